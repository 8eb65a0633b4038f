#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/named_values.hpp>

#include <algorithm>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace kanexpr {

/// The source of the inputs of a simulation: constants, by name or as a vector; a function of time; or a
/// controller, a function of time and state. A function returns an `input_values<System>` or fills one:
/// `[](double t, const state<System>& x, input_values<System>& r) { r[T] = -k * x[q]; }`. Prescribed motions
/// are inputs together with their derivatives (see `prescribe`).
template <class System>
class input_source {
  template <class Given>
  static constexpr bool is_vector = requires { Given::SizeAtCompileTime; }; // Eigen's vectors are callable

public:
  using state = kanexpr::state<System>;
  using inputs = input_values<System>;

  input_source() : input_source(given_inputs<System>()) {}
  input_source(std::initializer_list<named_value> constants)
      : input_source(given_inputs<System>(constants)) {}
  input_source(const given_inputs<System>& constants) : constants_(constants) {}
  template <class Vector>
    requires is_vector<Vector>
  input_source(const Vector& constants) : input_source(given_inputs<System>(constants)) {}

  template <std::invocable<double, const state&, inputs&> Fill>
    requires(!is_vector<Fill>)
  input_source(Fill fill) : give_(std::move(fill)), depends_on_state_(true) {}

  template <std::invocable<double, const state&> Controller>
    requires(std::convertible_to<std::invoke_result_t<Controller, double, const state&>, inputs> &&
             !is_vector<Controller>)
  input_source(Controller control)
      : give_([c = std::move(control)](double t, const state& x, inputs& r) mutable { r = c(t, x); }),
        depends_on_state_(true) {}

  template <std::invocable<double> Function>
    requires(std::convertible_to<std::invoke_result_t<Function, double>, inputs> && !is_vector<Function>)
  input_source(Function of_time)
      : give_([f = std::move(of_time)](double t, const state&, inputs& r) mutable { r = f(t); }) {}

  /// Assigns constants that were given by name, for a run-time model, whose symbols are known only at run
  /// time.
  template <class Known>
  void read(const Known& known) {
    if (constants_) constants_->read(known);
  }

  /// Returns a message that describes a mistake in the constants.
  const base::sentence& mistake() const {
    static constexpr base::sentence none{};
    return constants_ ? constants_->mistake : none;
  }
  bool depends_on_state() const { return depends_on_state_; }
  /// Returns the constant inputs; empty for a function.
  const std::optional<given_inputs<System>>& constants() const { return constants_; }

  /// Evaluates the inputs at a time and a state; inputs that a function leaves unset are NaN.
  void give(double t, const state& x, inputs& r) const {
    if (constants_) {
      r = constants_->values;
      return;
    }
    std::fill_n(r.data(), r.size(), std::numeric_limits<double>::quiet_NaN());
    give_(t, x, r);
  }

private:
  std::optional<given_inputs<System>> constants_{};
  std::function<void(double, const state&, inputs&)> give_{};
  bool depends_on_state_ = false;
};

} // namespace kanexpr
