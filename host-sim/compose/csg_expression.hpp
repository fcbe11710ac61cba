// Expressions of solids in a scene file, "(block | boss) - drill & envelope", as the sums of products that the renderer
// draws.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// A name in a product.
struct CsgTerm {
  std::string name;
  CsgUse use = CsgUse::intersected;
  friend bool operator==(const CsgTerm&, const CsgTerm&) = default;
};
/// What all intersected solids have in common, less the subtracted ones.
using CsgProduct = std::vector<CsgTerm>;

/// The products whose union an expression is: none that is empty whatever the solids are, none that lies in another,
/// no name twice in one. Or what is wrong with the expression. `a & b` comes before `a - b` and `a | b`, which go from
/// left to right; a name of other characters than letters, digits, '_' and '.' stands in ' '. At most
/// kMaxCsgOperands names in all products, at most 64 '(' in each other. What would take long to multiply out is wrong,
/// too.
std::variant<std::vector<CsgProduct>, std::string> products_of(const std::string& expression);

/// The names that no product has, because they change nothing: b in `a | a & b`. The expression has products.
std::vector<std::string> names_without_effect(const std::string& expression);

/// Whether an instance's name stands in ' ' in an expression.
bool needs_quotes(std::string_view name);

}  // namespace zstrip::sim
