#pragma once

#include <kanexpr/control.hpp>
#include <models/n_pendulum_cart.hpp>

#include <numbers>

/// A cart balances a pendulum, using two noisy sensors: the position of the cart and the angle of the
/// pendulum. A Kalman filter estimates the speeds, and a regulator computed by the compiler determines the
/// force.
namespace balanced_cart {

using namespace n_pendulum_cart;

using cart = System<1>;

constexpr auto parameters = constant_parameters<cart>({{m<0>, 1.5}, {m<1>, 0.4}, {l<0>, 0.8}, {g, 9.81}});
template <class T>
parameter_values<cart, T> parameters_in() {
  return {T(parameters[0]), T(parameters[1]), T(parameters[2]), T(parameters[3])};
}

constexpr double upright = std::numbers::pi / 2, period = 0.005;                  // rad, s
constexpr double place_noise = 0.005, angle_noise = 0.01, disturbing_force = 0.5; // m, rad, N

/// The cart near its equilibrium, over a period during which the force is constant.
constexpr auto linear =
    discretize(linearization<cart>::explicit_form.constant(
                   constant_state<cart>({{q<0>, 0}, {q<1>, upright}, {u<0>, 0}, {u<1>, 0}}), parameters,
                   constant_inputs<cart>({{F, 0}})),
               period);

constexpr auto regulator = dlqr(linear.A, linear.B, {1, 1, 0.1, 0.1}, {0.1});
static_assert(regulator);

/// The effect of the disturbing force on the state within a period.
constexpr auto disturbance =
    (disturbing_force * disturbing_force) * (linear.B * numeric::transposed(linear.B));

/// The controller, in the scalar type T.
template <class T>
class controller {
  using filter = basic_ekf<cart, T, q<0>, q<1>>;

public:
  using state = typename filter::state;
  using covariance = typename filter::covariance;
  using measurement = typename filter::measurement;

  controller(const state& guess, const covariance& uncertainty) : estimate(guess, uncertainty) {}

  /// Sets the force until the next call, one period later, from the current sensor values.
  status operator()(const measurement& y) {
    const auto p = parameters_in<T>();
    if (const status s = estimate.update(y, p, force, numeric::as_eigen(R)); !s) return s;
    const state equilibrium(0, T(upright), 0, 0);
    force = -numeric::as_eigen(K) * (estimate.x - equilibrium);
    return estimate.predict(estimate.t, T(period), p, force, numeric::as_eigen(Q));
  }

  input_values<cart, T> force = input_values<cart, T>::Zero();
  filter estimate; ///< between two calls, the prediction for the next call

private:
  static constexpr auto K = regulator.K.template cast<T>();
  static constexpr auto Q = disturbance.template cast<T>();
  static constexpr auto R =
      numeric::by_rows({{T(place_noise * place_noise), T(0)}, {T(0), T(angle_noise* angle_noise)}});
};

} // namespace balanced_cart
