// Expressions of solids: the products that they become are judged by truth tables of the expressions themselves.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "compose/composed_csg.hpp"
#include "compose/csg_expression.hpp"
#include "own_mesh.hpp"

namespace zstrip::sim::test {
namespace {

/// Bit i: inside of both or neither of the solids in which the bits of i say that a point lies.
using Truth = std::uint16_t;
constexpr Truth kSolids[4] = {0xAAAA, 0xCCCC, 0xF0F0, 0xFF00};
constexpr const char* kNames[4] = {"a", "b_2", "'left pot'", "d"};

struct Tree {
  std::string text;
  Truth truth;
};

Tree random_tree(std::mt19937& random, int depth) {
  if (depth == 0 || random() % 4 == 0) {
    const auto i = random() % 4;
    return {kNames[i], kSolids[i]};
  }
  const Tree left = random_tree(random, depth - 1), right = random_tree(random, depth - 1);
  const auto in_brackets = [](const Tree& a, const char* sign, const Tree& b) {
    std::string text = "( ";
    text += a.text;
    text += sign;
    text += b.text;
    text += ')';
    return text;
  };
  const int sign = static_cast<int>(random() % 3);
  if (sign == 0) return {in_brackets(left, "|", right), static_cast<Truth>(left.truth | right.truth)};
  if (sign == 1) return {in_brackets(left, " & ", right), static_cast<Truth>(left.truth & right.truth)};
  return {in_brackets(left, "-", right), static_cast<Truth>(left.truth & ~right.truth)};
}

Truth truth_of(const std::vector<CsgProduct>& products) {
  Truth sum = 0;
  for (const CsgProduct& product : products) {
    Truth all = 0xFFFF;
    bool intersects = false;
    std::set<std::string> names;
    for (const CsgTerm& term : product) {
      const auto* const name = std::find_if(std::begin(kNames), std::end(kNames), [&](const std::string& known) {
        return known == term.name || (known[0] == '\'' && known.substr(1, known.size() - 2) == term.name);
      });
      if (name == std::end(kNames) || !names.insert(term.name).second) {
        ADD_FAILURE() << term.name;
        continue;
      }
      const Truth inside = kSolids[name - kNames];
      all = static_cast<Truth>(all & (term.use == CsgUse::intersected ? inside : ~inside));
      intersects |= term.use == CsgUse::intersected;
    }
    EXPECT_TRUE(intersects) << "a product of subtracted solids alone";
    EXPECT_NE(all, 0) << "a product that is empty";
    sum = static_cast<Truth>(sum | all);
  }
  return sum;
}

std::string wrong_with(const std::string& expression) {
  const auto result = products_of(expression);
  return std::holds_alternative<std::string>(result) ? std::get<std::string>(result) : "nothing";
}

TEST(CsgExpression, ProductsAreTheExpression) {
  std::mt19937 random(5);
  int empty = 0;
  for (int i = 0; i < 3000; ++i) {
    const Tree tree = random_tree(random, 1 + i % 5);
    const auto result = products_of(tree.text);
    if (tree.truth == 0) {
      EXPECT_EQ(wrong_with(tree.text), "there is nothing left of it") << tree.text;
      ++empty;
      continue;
    }
    ASSERT_TRUE(std::holds_alternative<std::vector<CsgProduct>>(result)) << tree.text << ": " << wrong_with(tree.text);
    EXPECT_EQ(truth_of(std::get<std::vector<CsgProduct>>(result)), tree.truth) << tree.text;
  }
  EXPECT_GT(empty, 50);
}

TEST(CsgExpression, IntersectionComesFirstAndTheRestFromLeftToRight) {
  const auto truth = [](const std::string& text) { return truth_of(std::get<0>(products_of(text))); };
  EXPECT_EQ(truth("a|b_2-d"), truth("(a|b_2)-d"));
  EXPECT_EQ(truth("a-b_2|d"), truth("(a-b_2)|d"));
  EXPECT_EQ(truth("a-b_2&d"), truth("a-(b_2&d)"));
  EXPECT_EQ(truth("a&b_2|d"), truth("(a&b_2)|d"));
}

TEST(CsgExpression, UnionsThatAreSubtractedAreOneProduct) {
  const auto products = std::get<0>(products_of("a - (b_2 | d)"));
  ASSERT_EQ(products.size(), 1U);
  EXPECT_EQ(products[0], (CsgProduct{{"a"}, {"b_2", CsgUse::subtracted}, {"d", CsgUse::subtracted}}));
}

TEST(CsgExpression, SaysWhatIsWrong) {
  EXPECT_EQ(wrong_with("a - "), "a name is missing at its end");
  EXPECT_EQ(wrong_with(""), "a name is missing at its end");
  EXPECT_EQ(wrong_with("(a | b"), "')' is missing");
  EXPECT_EQ(wrong_with("a b"), "'b' is not expected");
  EXPECT_EQ(wrong_with("a - + b"), "there is '+' where a name is expected");
  EXPECT_EQ(wrong_with("'a"), "the ' that ends a name is missing");
  EXPECT_EQ(wrong_with(std::string(100, '(')), "there are more than 64 '(' in each other");
  std::string many = "a0";
  for (int i = 1; i < 1025; ++i) many += "|a" + std::to_string(i);
  EXPECT_EQ(wrong_with(many), "multiplied out it has more than 1024 products");
  EXPECT_EQ(wrong_with("(a|b|c|d|e) & (f|g|h|i|j) & (k|l)"),
            "multiplied out it has 150 solids in 50 products; there may be 64 in all");
}

/// They took seconds to minutes; now the steps are counted.
TEST(CsgExpression, WhatTakesLongToMultiplyOutIsRefusedAtOnce) {
  const auto joined = [](const char* sign, int count, auto part) {
    std::string text = part(0);
    for (int i = 1; i < count; ++i) text.append(sign).append(part(i));
    return text;
  };
  const auto pair = [](int i) { return fmt::format("(a{0} | b{0})", i); };
  const auto name = [](int i) { return fmt::format("c{}", i); };
  const std::string sums = joined(" & ", 10, pair);  // 1024 products
  const std::string names = joined(" & ", 5000, name);
  const std::string wide = "(" + joined(" & ", 500, name) + ") & (" + joined(" | ", 400, pair) + ")";
  for (const std::string& text : {sums, "d - (" + sums + ")", "(" + sums + ") - (" + sums + ")", names, wide}) {
    EXPECT_EQ(wrong_with(text), "it is too long when it is multiplied out; make several [[csg]] of it")
        << text.substr(0, 60);
  }
}

// It ended the expression.
TEST(CsgExpression, ANulIsACharacter) {
  using namespace std::string_literals;
  EXPECT_EQ(wrong_with("a\0 - b"s), "the character 0 is not expected");
  EXPECT_EQ(wrong_with("a - \0b"s), "there is the character 0 where a name is expected");
}

TEST(OpenEdges, AreThoseOfOneTriangle) {
  zstrip::test::OwnMesh box = zstrip::test::faceted_box();
  EXPECT_EQ(open_edges(box.mesh()), 0U);
  EXPECT_EQ(open_edges(zstrip::test::sphere(6, 9).mesh()), 0U);
  box.triangles.pop_back();
  EXPECT_EQ(open_edges(box.mesh()), 3U);
  box.triangles.pop_back();
  EXPECT_EQ(open_edges(box.mesh()), 4U);
  box = zstrip::test::faceted_box();
  std::swap(box.triangles[0].a, box.triangles[0].b);
  EXPECT_EQ(open_edges(box.mesh()), 3U) << "a face the other way round";
}

}  // namespace
}  // namespace zstrip::sim::test
