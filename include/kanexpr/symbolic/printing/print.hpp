#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <string>
#include <string_view>

namespace kanexpr::symbolic {

/// Writes plain text such as `m*r^2/4 - sin(q1)^2`.
KANEXPR_ENGINE std::string print(const graph& g, int id);
KANEXPR_ENGINE std::string print(expression e);

/// Writes a matrix with one row per line and aligned columns, after an optional prefix: `print(m, "M = ")`.
KANEXPR_ENGINE std::string print(const matrix& m, std::string_view before = {});

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/printing/plain_text_form.hpp>
#endif
