#pragma once

#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string>
#include <vector>

namespace gallery {

/// Equations under a heading, each in LaTeX.
struct equation_group {
  std::string heading{};
  std::vector<std::string> lines{};
  std::string note{};     ///< a sentence below them, if any
  bool is_folded = false; ///< the page hides them until a reader opens them, because they are long
};

/// The equations of a model as a textbook prints them: the kinematic differential equations, the constraints,
/// and the dynamic equations in the shorter of the forms u̇ = … and M u̇ = f. In long
/// dynamic equations, names stand for their common parts. If they are too long for a page even so, their
/// operations are counted, and the shortest entries of M and f represent the rest.
std::vector<equation_group> equations_of(kanexpr::model& m);

/// The symbol of a kind at a place among those of its kind, in LaTeX.
std::string latex_of(kanexpr::model& m, kanexpr::symbolic::symbol_kind kind, int place);

} // namespace gallery
