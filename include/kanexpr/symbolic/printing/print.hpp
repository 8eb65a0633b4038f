#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace kanexpr::symbolic {

/// Writes plain text such as `m*r^2/4 - sin(q1)^2`. A text with more than `longest` characters is written
/// with names for its parts that occur more than once, or that are long. The definitions of these parts
/// follow, each after those that it refers to:
///
///     c/z1 + u1*z1
///     where
///       z1 = a*cos(q1) + b*sin(q1 + q2)
///
/// No symbol has the same name as a part.
KANEXPR_ENGINE std::string print(const graph& g, int id, std::size_t longest = longest_text);
KANEXPR_ENGINE std::string print(expression e, std::size_t longest = longest_text);

/// Writes an expression within a sentence or a label, without its middle if it is long.
KANEXPR_ENGINE std::string print_in_sentence(expression e);

/// Writes several expressions, with common named parts if they have more than `longest` characters together.
KANEXPR_ENGINE text_with_parts print_each(const sequence<expression>& all,
                                          std::size_t longest = longest_text);

/// Writes a matrix with one row per line and aligned columns, after an optional prefix: `print(m, "M = ")`.
/// The entries of a matrix with more than `longest` characters share their parts.
KANEXPR_ENGINE std::string print(const matrix& m, std::string_view before = {},
                                 std::size_t longest = longest_text);
KANEXPR_ENGINE std::string print(const matrix& m, std::size_t longest);

} // namespace kanexpr::symbolic

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/symbolic/printing/plain_text_form.hpp>
#endif
