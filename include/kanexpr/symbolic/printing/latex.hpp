#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <cstddef>
#include <string>

namespace kanexpr::symbolic {

/// Writes LaTeX for math mode, such as `\frac{m r^{2}}{4} - \sin^{2} q_1`. A text with more than `longest`
/// characters is written as an `aligned` environment, in which definitions of parts follow the expression, as
/// in a long text from `print`.
KANEXPR_ENGINE std::string latex(const graph& g, int id, std::size_t longest = longest_text);
KANEXPR_ENGINE std::string latex(expression e, std::size_t longest = longest_text);
/// Writes several expressions, as `print_each`.
KANEXPR_ENGINE text_with_parts latex_each(const sequence<expression>& all,
                                          std::size_t longest = longest_text);
/// Writes a matrix as a `bmatrix` environment.
KANEXPR_ENGINE std::string latex(const matrix& m, std::size_t longest = longest_text);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/printing/latex_form.hpp>
#endif
