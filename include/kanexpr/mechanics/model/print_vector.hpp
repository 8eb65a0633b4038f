#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>

#include <string>

namespace kanexpr::mechanics {

/// The labels of the axes of a frame.
enum class basis_style { xyz, one_two_three, ijk };

/// Returns plain text, such as `u1*L.x + (u2 + u3)*L.y`; a dyad is written as `Ixx*(L.x|L.x)`.
KANEXPR_ENGINE std::string print(const mechanism& m, const vector& v, basis_style style = basis_style::xyz);
KANEXPR_ENGINE std::string print(const mechanism& m, const dyadic& d, basis_style style = basis_style::xyz);

/// Returns LaTeX for math mode, such as `u_1\,\hat{\mathbf{l}}_{x}`.
KANEXPR_ENGINE std::string latex(const mechanism& m, const vector& v, basis_style style = basis_style::xyz);
KANEXPR_ENGINE std::string latex(const mechanism& m, const dyadic& d, basis_style style = basis_style::xyz);

} // namespace kanexpr::mechanics

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/mechanics/model/vector_text.hpp>
#endif
