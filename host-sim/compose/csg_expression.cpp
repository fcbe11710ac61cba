// Reads an expression of solids and multiplies it out; see csg_expression.hpp.
#include "compose/csg_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace zstrip::sim {
namespace {

using Products = std::vector<CsgProduct>;

/// Far more than are drawn, because many of them may lie in others; each is compared with all others.
constexpr std::size_t kMaxProducts = 1024;
constexpr int kDeepest = 64;

CsgUse other(CsgUse use) { return use == CsgUse::intersected ? CsgUse::subtracted : CsgUse::intersected; }

bool has(const CsgProduct& product, const CsgTerm& term) { return std::ranges::find(product, term) != product.end(); }

/// Both together; nothing where that is empty.
std::optional<CsgProduct> both(const CsgProduct& a, const CsgProduct& b) {
  CsgProduct product = a;
  for (const CsgTerm& term : b) {
    if (has(product, {term.name, other(term.use)})) return {};
    if (!has(product, term)) product.push_back(term);
  }
  return product;
}

/// Adds a product, unless it lies in one that is there; those that lie in it go.
void add(Products& sum, const CsgProduct& product) {
  const auto lies_in = [](const CsgProduct& inner, const CsgProduct& outer) {
    return std::ranges::all_of(outer, [&inner](const CsgTerm& term) { return has(inner, term); });
  };
  if (std::ranges::any_of(sum, [&](const CsgProduct& known) { return lies_in(product, known); })) return;
  std::erase_if(sum, [&](const CsgProduct& known) { return lies_in(known, product); });
  sum.push_back(product);
}

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  std::variant<Products, std::string> run() {
    const Products products = sum(0);
    if (wrong_.empty() && !at_end()) fail(fmt::format("{} is not expected", here()));
    if (!wrong_.empty()) return wrong_;
    std::size_t terms = 0;
    for (const CsgProduct& product : products) terms += product.size();
    if (products.empty()) return "there is nothing left of it";
    if (terms > kMaxCsgOperands) {
      return fmt::format("multiplied out it has {} solids in {}; there may be {} in all", terms,
                         products.size() == 1 ? "one product" : fmt::format("{} products", products.size()),
                         kMaxCsgOperands);
    }
    return products;
  }

  /// Of an expression that has been read.
  const std::set<std::string>& names() const { return names_; }

 private:
  Products sum(int depth) {
    Products left = product(depth);
    while (wrong_.empty() && (peek() == '|' || peek() == '-')) {
      const bool unites = text_[at_++] == '|';
      const Products right = product(depth);
      if (unites) {
        for (const CsgProduct& one : right) add(left, one);
      } else {
        left = less(left, right);
      }
      check(left);
    }
    return left;
  }

  Products product(int depth) {
    Products left = operand(depth);
    while (wrong_.empty() && peek() == '&') {
      ++at_;
      left = common(left, operand(depth));
      check(left);
    }
    return left;
  }

  Products operand(int depth) {
    if (!wrong_.empty()) return {};
    if (peek() == '(') {
      ++at_;
      if (depth == kDeepest) fail(fmt::format("there are more than {} '(' in each other", kDeepest));
      if (!wrong_.empty()) return {};
      Products inner = sum(depth + 1);
      if (wrong_.empty() && peek() != ')') fail("')' is missing");
      ++at_;
      return inner;
    }
    std::string name;
    if (peek() == '\'') {
      const std::size_t end = text_.find('\'', ++at_);
      if (end == std::string::npos) {
        fail("the ' that ends a name is missing");
        return {};
      }
      name = text_.substr(at_, end - at_);
      at_ = end + 1;
    } else {
      for (; is_of_name(peek_here()); ++at_) name += text_[at_];
    }
    if (name.empty()) {
      fail(at_end() ? std::string("a name is missing at its end")
                    : fmt::format("there is {} where a name is expected", here()));
    }
    names_.insert(name);
    return {{{name, CsgUse::intersected}}};
  }

  static Products common(const Products& a, const Products& b) {
    Products result;
    for (const CsgProduct& one : a) {
      for (const CsgProduct& of_b : b) {
        if (const std::optional<CsgProduct> product = both(one, of_b)) add(result, *product);
        if (result.size() > kMaxProducts) return result;
      }
    }
    return result;
  }

  /// What is outside of a product is outside of one of its solids.
  static Products less(Products a, const Products& b) {
    for (const CsgProduct& product : b) {
      Products outside;
      for (const CsgTerm& term : product) outside.push_back({{term.name, other(term.use)}});
      a = common(a, outside);
    }
    return a;
  }

  void check(const Products& products) {
    if (products.size() > kMaxProducts) fail(fmt::format("multiplied out it has more than {} products", kMaxProducts));
  }
  void fail(const std::string& what) {
    if (wrong_.empty()) wrong_ = what;
  }
  /// 0 at the end; a character of the text may be 0, too.
  char peek_here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool at_end() {
    peek();
    return at_ == text_.size();
  }
  /// What stands here, in words.
  std::string here() {
    const auto c = static_cast<unsigned char>(peek());
    return c < 0x20 || c == 0x7F ? fmt::format("the character {}", c) : fmt::format("'{}'", peek());
  }
  char peek() {
    while (peek_here() == ' ' || peek_here() == '\t' || peek_here() == '\n' || peek_here() == '\r') ++at_;
    return peek_here();
  }
  const std::string& text_;
  std::size_t at_ = 0;
  std::string wrong_;
  std::set<std::string> names_;
};

}  // namespace

std::variant<std::vector<CsgProduct>, std::string> products_of(const std::string& expression) {
  return Parser(expression).run();
}

std::vector<std::string> names_without_effect(const std::string& expression) {
  Parser parser(expression);
  const auto result = parser.run();
  std::set<std::string> names = parser.names();
  if (const auto* const products = std::get_if<Products>(&result)) {
    for (const CsgProduct& product : *products) {
      for (const CsgTerm& term : product) names.erase(term.name);
    }
  }
  return {names.begin(), names.end()};
}

bool needs_quotes(std::string_view name) { return !std::ranges::all_of(name, is_of_name); }

}  // namespace zstrip::sim
