#pragma once

#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/inertia.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

namespace kanexpr::mechanics {

/// I·α + ω×(I·ω) about a point, from the matrix U that the forces also use. Because the products of inertia
/// weight the entries of U directly, this takes half as many multiplications as the two-step form.
constexpr components inertia_moment(const symmetric& i, const components& w, const components& alpha,
                                    const matrix3& u) {
  components moment;
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    moment[x] = i(x, x) * alpha[x];
    const expression difference = i(z, z) - i(y, y);
    moment[x] += difference * (w[y] * w[z]);
    moment[x] += i(y, z) * difference_of_products(w[y], w[y], w[z], w[z]);
    moment[x] += i(z, x) * u(y, x);
    moment[x] -= i(x, y) * u(z, x);
  }
  return moment;
}

} // namespace kanexpr::mechanics
