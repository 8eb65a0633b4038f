#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <string>

namespace kanexpr::symbolic {

/// Writes LaTeX for math mode, such as `\frac{m r^{2}}{4} - \sin^{2} q_1`.
KANEXPR_ENGINE std::string latex(const graph& g, int id);
KANEXPR_ENGINE std::string latex(expression e);
KANEXPR_ENGINE std::string latex(const matrix& m);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/printing/latex_form.hpp>
#endif
