// Expressions of solids in a scene file, "(block | boss) - drill & envelope", as the unions of products that the
// renderer draws.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// A solid in a product.
struct CsgTerm {
  std::string name;
  CsgUse use = CsgUse::intersected;
  friend bool operator==(const CsgTerm&, const CsgTerm&) = default;
};
/// The intersection of all intersected solids, minus the subtracted ones.
using CsgProduct = std::vector<CsgTerm>;

/// Returns the products whose union is the expression: none is empty for all solids, none is contained in another, and
/// none has a name twice. Or returns the error of the expression. `a & b` comes before `a - b` and `a | b`, which are
/// evaluated from left to right; names with other characters than letters, digits, '_' and '.' must be in ' '. All
/// products together have at most kMaxCsgOperands names; at most 64 '(' may be nested. An expression that takes too
/// long to expand is an error, too.
std::variant<std::vector<CsgProduct>, std::string> products_of(const std::string& expression);

/// Returns the names that are in no product, because they have no effect: b in `a | a & b`. The expression must have
/// products.
std::vector<std::string> names_without_effect(const std::string& expression);

/// True if an instance's name must be in ' ' in an expression.
bool needs_quotes(std::string_view name);

}  // namespace zstrip::sim
