// Parses an expression of solids and expands it; see csg_expression.hpp.
#include "compose/csg_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace zstrip::sim {
namespace {

/// A solid, by its index in Parser::names(): twice the index, plus 1 if it is subtracted.
using Term = std::size_t;
using Product = std::vector<Term>;
using Products = std::vector<Product>;

/// More than can be drawn, because many of them may be contained in others.
constexpr std::size_t kMaxProducts = 1024;
/// Limit for the terms that are examined. Each product is compared with all others, so that a short text could take
/// minutes.
constexpr std::uint64_t kMaxSteps = 2'000'000;
constexpr int kDeepest = 64;

Term other(Term term) { return term ^ 1; }
bool is_subtracted(Term term) { return term % 2 != 0; }

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  std::variant<std::vector<CsgProduct>, std::string> run() {
    const Products products = sum(0);
    if (wrong_.empty() && !at_end()) fail(fmt::format("{} is not expected", here()));
    if (!wrong_.empty()) return wrong_;
    std::size_t terms = 0;
    for (const Product& product : products) terms += product.size();
    if (products.empty()) return "there is nothing left of it";
    if (terms > kMaxCsgOperands) {
      return fmt::format("multiplied out it has {} solids in {}; there may be {} in all", terms,
                         products.size() == 1 ? "one product" : fmt::format("{} products", products.size()),
                         kMaxCsgOperands);
    }
    std::vector<CsgProduct> named;
    for (const Product& product : products) {
      CsgProduct& to = named.emplace_back();
      for (const Term term : product) {
        to.push_back({names_[term / 2], is_subtracted(term) ? CsgUse::subtracted : CsgUse::intersected});
      }
    }
    return named;
  }

  /// Returns the names in a parsed expression, each once.
  const std::vector<std::string>& names() const { return names_; }

 private:
  Products sum(int depth) {
    Products left = product(depth);
    while (wrong_.empty() && (peek() == '|' || peek() == '-')) {
      const bool unites = text_[at_++] == '|';
      const Products right = product(depth);
      if (unites) {
        for (const Product& one : right) {
          add(left, one);
          if (!check(left)) break;
        }
      } else {
        left = less(left, right);
      }
    }
    return left;
  }

  Products product(int depth) {
    Products left = operand(depth);
    while (wrong_.empty() && peek() == '&') {
      ++at_;
      left = common(left, operand(depth));
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
    const auto [known, is_new] = numbers_.try_emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return Products{Product{2 * known->second}};
  }

  bool has(const Product& product, Term term) {
    steps_ += product.size();
    return std::ranges::find(product, term) != product.end();
  }
  bool lies_in(const Product& inner, const Product& outer) {
    return std::ranges::all_of(outer, [&](Term term) { return has(inner, term); });
  }

  /// Returns the intersection; nothing if it is always empty.
  std::optional<Product> both(const Product& a, const Product& b) {
    steps_ += a.size();
    Product product = a;
    for (const Term term : b) {
      if (has(product, other(term))) return {};
      if (!has(product, term)) product.push_back(term);
    }
    return product;
  }

  /// Adds a product unless it is contained in another one; removes products that are contained in it.
  void add(Products& sum, const Product& product) {
    if (std::ranges::any_of(sum, [&](const Product& known) { return lies_in(product, known); })) return;
    std::erase_if(sum, [&](const Product& known) { return lies_in(known, product); });
    sum.push_back(product);
  }

  Products common(const Products& a, const Products& b) {
    Products result;
    for (const Product& one : a) {
      for (const Product& of_b : b) {
        if (const std::optional<Product> product = both(one, of_b)) add(result, *product);
        if (!check(result)) return {};
      }
    }
    return result;
  }

  /// A point outside of a product is outside of one of its solids.
  Products less(Products a, const Products& b) {
    for (const Product& product : b) {
      Products outside;
      for (const Term term : product) outside.push_back({other(term)});
      a = common(a, outside);
    }
    return a;
  }

  /// Returns false if the limits are exceeded.
  bool check(const Products& products) {
    if (products.size() > kMaxProducts) fail(fmt::format("multiplied out it has more than {} products", kMaxProducts));
    if (steps_ > kMaxSteps) fail("it is too long when it is multiplied out; make several [[csg]] of it");
    return wrong_.empty();
  }
  void fail(const std::string& what) {
    if (wrong_.empty()) wrong_ = what;
  }
  /// Returns 0 at the end; a character of the text may also be 0.
  char peek_here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool at_end() {
    peek();
    return at_ == text_.size();
  }
  /// Describes the text at this position.
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
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> numbers_;  ///< of names_
  std::uint64_t steps_ = 0;
};

}  // namespace

std::variant<std::vector<CsgProduct>, std::string> products_of(const std::string& expression) {
  return Parser(expression).run();
}

std::vector<std::string> names_without_effect(const std::string& expression) {
  Parser parser(expression);
  const auto result = parser.run();
  std::set<std::string> names(parser.names().begin(), parser.names().end());
  if (const auto* const products = std::get_if<std::vector<CsgProduct>>(&result)) {
    for (const CsgProduct& product : *products) {
      for (const CsgTerm& term : product) names.erase(term.name);
    }
  }
  return {names.begin(), names.end()};
}

bool needs_quotes(std::string_view name) { return !std::ranges::all_of(name, is_of_name); }

}  // namespace zstrip::sim
