#pragma once

#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/units_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/model/inertial_parameter.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace kanexpr {

/// The inverse dynamics of a system as a linear function of the inertial parameters of its bodies,
///
///     τ = Y(t, q, u, u̇) π + τ_0(t, q, u)
///
/// τ are the generalized forces that must act on the independent speeds in addition to the loads, as in
/// `equations_of_motion<System>`. The part Y π covers inertia and gravity of every body; τ_0 balances all
/// other loads of the model, including those that contain a mass. Y is valid for any π: it does not depend on
/// the masses and inertias that the model specifies.
///
/// π contains a mass for each particle and ten numbers for each rigid body, in SI units kg, kg m and kg m²:
/// m, the first moments m*x, m*y and m*z, and ixx, iyy, izz, ixy, iyz and izx with the sign of I = Σ m (r·r E
/// − r r). They refer to the axes of the body's frame and to its joint, that is, to the last point fixed in
/// the body on the way from the mass center back to the origin.
template <class System>
struct regressor {
  using quantity = mechanics::quantity;
  static constexpr const derivation::survey& known = compiled::survey_of<System>;

  /// The number of entries of π.
  static constexpr int size = known.inertial_parameters;
  template <class Number = double>
  using values = Eigen::Matrix<Number, size, 1>;

  /// Y, with a row for each independent speed: `regressor<System>::matrix(x, p, r, a)` with the rates of all
  /// speeds.
  static constexpr function<System, quantity::regressor> matrix{};
  /// τ_0: f(x, p, r).
  static constexpr function<System, quantity::load_compensation> remainder{};
  /// π as specified by the model: f(x, p).
  static constexpr function<System, quantity::inertial_parameters> parameters{};

  /// The names of the entries of π, body by body: "m of Link", "m*x of Link", … "izx of Link".
  static constexpr std::array<base::name, static_cast<std::size_t>(size)> names = [] {
    std::array<base::name, static_cast<std::size_t>(size)> all{};
    if constexpr (size > 0) {
      const derivation::derived_system system(System::record,
                                              derivation::stages_of<System>::constrained.stored);
      std::size_t next = 0;
      for (const base::name& each : mechanics::names_of_inertial_parameters(system.mechanism()))
        all[next++] = each;
    }
    return all;
  }();

  /// The units of the entries of π: kg, kg m or kg m²; none if the system states no units.
  static constexpr std::array<mechanics::possible_unit, static_cast<std::size_t>(size)> units = [] {
    std::array<mechanics::possible_unit, static_cast<std::size_t>(size)> all{};
    if constexpr (compiled::stated_units_of<System>() != nullptr)
      for (int i = 0; i < size; ++i)
        all[static_cast<std::size_t>(i)] = compiled::unit_table_of<System>.inertial_parameter(i);
    return all;
  }();

  /// Returns the number of operations of one call of a function.
  template <auto... wanted>
  static constexpr symbolic::cost cost(function<System, wanted...> f) {
    return f.cost();
  }
};

} // namespace kanexpr
