#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>

namespace kanexpr::mechanics {

/// Quantities as Taylor series of first or second order in the amplitudes q of a flexible body:
/// f_i(q) = c_i + Σ_k c_k,i q_k + ½ Σ_kl c_kl,i q_k q_l, with c_kl = c_lk.
struct taylor_series {
  int quantities = 0;
  int amplitudes = 0;
  base::sequence<double> coefficients{}; ///< c, then c_k by amplitude, then c_kl row by row

  constexpr taylor_series() = default;
  constexpr taylor_series(int quantities_, int amplitudes_, int order = 2)
      : quantities(quantities_), amplitudes(amplitudes_),
        coefficients(quantities_ * (1 + amplitudes_ + (order > 1 ? amplitudes_ * amplitudes_ : 0))) {}

  /// Whether the list of coefficients has the length that belongs to the numbers of quantities and
  /// amplitudes.
  constexpr bool is_complete(int quantities_, int amplitudes_) const {
    const int linear = quantities * (1 + amplitudes), square = quantities * amplitudes * amplitudes;
    return quantities == quantities_ && amplitudes == amplitudes_ &&
           (coefficients.size() == linear || coefficients.size() == linear + square);
  }
  constexpr bool has_quadratic() const { return coefficients.size() > quantities * (1 + amplitudes); }
  constexpr double& constant(int i) { return coefficients[i]; }
  constexpr double constant(int i) const { return coefficients[i]; }
  constexpr double& linear(int k, int i) { return coefficients[(1 + k) * quantities + i]; }
  constexpr double linear(int k, int i) const { return coefficients[(1 + k) * quantities + i]; }
  constexpr double& quadratic(int k, int l, int i) {
    return coefficients[(1 + amplitudes + k * amplitudes + l) * quantities + i];
  }
  constexpr double quadratic(int k, int l, int i) const {
    return coefficients[(1 + amplitudes + k * amplitudes + l) * quantities + i];
  }
};

/// A place of a flexible body at which joints, loads and other bodies attach.
struct flexible_node {
  base::name called{};
  taylor_series position{}; ///< from the reference point; 3 components
  /// Row by row: v in body axes = orientation · v in the node's axes. Empty: the axes are those of the body.
  base::sequence<double> orientation{};
  /// The rotation vector in body axes: its derivatives with respect to the amplitudes, 3 components each.
  /// Empty: zero.
  base::sequence<double> rotation{};
  /// Its second derivatives, row by row; they are symmetric. Empty: zero.
  base::sequence<double> second_rotation{};

  /// Whether all lists have the lengths that belong to the number of amplitudes.
  constexpr bool is_complete(int amplitudes) const {
    const auto has_size = [](const base::sequence<double>& list, int size) {
      return list.empty() || list.size() == size;
    };
    return position.is_complete(3, amplitudes) && has_size(orientation, 9) &&
           has_size(rotation, 3 * amplitudes) && has_size(second_rotation, 3 * amplitudes * amplitudes);
  }
};

/// A term of third or fourth order in an elastic energy: the product of a coefficient and amplitudes, which
/// are given by their indices.
struct elastic_term {
  double coefficient = 0;
  int amplitudes[4]{-1, -1, -1, -1}; ///< -1: none

  /// Whether all indices are those of amplitudes.
  constexpr bool is_valid(int count) const {
    for (int i = 0; i < 4; ++i)
      if (amplitudes[i] >= count || amplitudes[i] < (i == 3 ? -1 : 0)) return false;
    return true;
  }
};

/// A term in an entry of a symmetric damping matrix, and in the opposite entry: the product of a coefficient
/// and one or two amplitudes, which are given by their indices.
struct damping_term {
  double coefficient = 0;
  int row = 0, column = 0;
  int amplitudes[2]{-1, -1}; ///< -1: none

  /// Whether all indices are those of amplitudes.
  constexpr bool is_valid(int count) const {
    const auto is_index = [&](int k) { return k >= 0 && k < count; };
    return is_index(row) && is_index(column) && is_index(amplitudes[0]) &&
           (amplitudes[1] == -1 || is_index(amplitudes[1]));
  }
};

/// The numbers that define a flexible body, in SI units and in the axes of its frame: the integrals of
/// `flexible_body` as series in the amplitudes, and its elasticity. r is measured from the reference point.
/// Definitions: Wallrapp (1994), Standardization of flexible body modeling in multibody system codes, with
/// the names mdCM and Ct, J and Oe, Cr, Me, ksigma, Ke and De for the members after `mass`.
struct flexible_data {
  int amplitudes = 0;
  double mass = 0;
  taylor_series first_moment{};        ///< ∫ r dm
  taylor_series inertia{};             ///< ∫ (r·r E − r r) dm: xx, yy, zz, xy, yz, zx
  taylor_series angular{};             ///< ∫ r × ∂r/∂q_k dm: 3 components by amplitude; of first order
  base::sequence<double> modal_mass{}; ///< row by row, as are the following two
  base::sequence<double> stiffness{};  ///< the elastic energy is f·q + ½ q·K q
  base::sequence<double> damping{};    ///< the damping forces are −D q̇
  base::sequence<double> preload{};    ///< f, the generalized forces of reference stresses
  base::sequence<elastic_term> elastic_terms{}; ///< of the elastic energy, of higher than second order
  base::sequence<damping_term> damping_terms{}; ///< of D that depend on the amplitudes
  base::sequence<flexible_node> nodes{};

  constexpr flexible_data() = default;
  constexpr explicit flexible_data(int amplitudes_)
      : amplitudes(amplitudes_), first_moment(3, amplitudes_), inertia(6, amplitudes_),
        angular(3 * amplitudes_, amplitudes_, 1), modal_mass(amplitudes_ * amplitudes_),
        stiffness(amplitudes_ * amplitudes_), damping(amplitudes_ * amplitudes_), preload(amplitudes_) {}

  /// Whether all lists have the lengths that belong to the number of amplitudes.
  constexpr bool is_complete() const {
    const int n = amplitudes;
    return n > 0 && first_moment.is_complete(3, n) && inertia.is_complete(6, n) &&
           angular.is_complete(3 * n, n) && modal_mass.size() == n * n && stiffness.size() == n * n &&
           damping.size() == n * n && preload.size() == n && has_valid_terms();
  }

private:
  constexpr bool has_valid_terms() const {
    bool valid = true;
    for (const elastic_term& t : elastic_terms) valid = valid && t.is_valid(amplitudes);
    for (const damping_term& t : damping_terms) valid = valid && t.is_valid(amplitudes);
    return valid;
  }
};

} // namespace kanexpr::mechanics
