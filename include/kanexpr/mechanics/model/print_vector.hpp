#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <cstddef>
#include <string>

namespace kanexpr::mechanics {

/// The labels of the axes of a frame.
enum class basis_style { xyz, one_two_three, ijk };

/// Returns plain text, such as `u1*L.x + (u2 + u3)*L.y`; a dyad is written as `Ixx*(L.x|L.x)`. In a text with
/// more than `longest` characters, long and repeated parts have names, as in `symbolic::print`.
KANEXPR_ENGINE std::string print(const mechanism& m, const vector& v, basis_style style = basis_style::xyz,
                                 std::size_t longest = symbolic::longest_text);
KANEXPR_ENGINE std::string print(const mechanism& m, const dyadic& d, basis_style style = basis_style::xyz,
                                 std::size_t longest = symbolic::longest_text);

/// Returns LaTeX for math mode, such as `u_1\,\hat{\mathbf{l}}_{x}`, with named parts as `symbolic::latex`.
KANEXPR_ENGINE std::string latex(const mechanism& m, const vector& v, basis_style style = basis_style::xyz,
                                 std::size_t longest = symbolic::longest_text);
KANEXPR_ENGINE std::string latex(const mechanism& m, const dyadic& d, basis_style style = basis_style::xyz,
                                 std::size_t longest = symbolic::longest_text);

} // namespace kanexpr::mechanics

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/mechanics/model/vector_text.hpp>
#endif
