#pragma once

#include <array>
#include <string_view>
#include <type_traits>

/// The coefficients of the fixed-step methods. To add a method, add its coefficients here and its class
/// template in fixed_step.hpp; derivatives of steps and exported steps follow from the coefficients.
namespace kanexpr::steps {

/// A method in which each stage depends only on the preceding one: stage s evaluates the rates k_s at t + c_s
/// h and x + h a_s k_{s-1}, and the step is x + h Σ b_s k_s. A partitioned method has separate coefficients a
/// and b for the coordinates and the speeds, in this order (Hairer, Lubich & Wanner, Geometric Numerical
/// Integration, 2006, II.2).
struct tableau {
  static constexpr int most_stages = 4;
  struct stage {
    std::array<double, 2> a{}, b{};
    double c = 0;
  };

  std::string_view name{};  ///< the identifier, such as `runge_kutta_4`
  std::string_view title{}; ///< the name in generated text
  int stages = 0;
  std::array<stage, most_stages> stage_at{};

  constexpr const stage& at(int s) const { return stage_at[static_cast<std::size_t>(s)]; }
};

/// Returns a stage of an explicit Runge-Kutta method.
constexpr tableau::stage explicit_stage(double a, double b) { return {{a, a}, {b, b}, a}; }

/// Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, 1993, II.1.
inline constexpr tableau runge_kutta_4{"runge_kutta_4",
                                       "the classic Runge-Kutta method",
                                       4,
                                       {explicit_stage(0, 1.0 / 6), explicit_stage(0.5, 1.0 / 3),
                                        explicit_stage(0.5, 1.0 / 3), explicit_stage(1, 1.0 / 6)}};

/// Ralston, Runge-Kutta methods with minimum error bounds, Mathematics of Computation 16, 1962.
inline constexpr tableau ralston_3{
    "ralston_3",
    "Ralston's method of third order",
    3,
    {explicit_stage(0, 2.0 / 9), explicit_stage(0.5, 1.0 / 3), explicit_stage(0.75, 4.0 / 9)}};

/// Hairer, Lubich & Wanner, Geometric Numerical Integration, 2006, I.1.2.
inline constexpr tableau semi_implicit_euler{
    "semi_implicit_euler", "semi-implicit Euler", 2, {{{{0, 0}, {0, 1}, 0}, {{0, 1}, {1, 0}, 0}}}};

inline constexpr std::array<const tableau*, 3> tableaux{&runge_kutta_4, &ralston_3, &semi_implicit_euler};

/// Returns the method with the given name, or a null pointer if there is none.
constexpr const tableau* find_tableau(std::string_view name) {
  for (const tableau* each : tableaux)
    if (each->name == name) return each;
  return nullptr;
}

/// The coefficients of an explicit method in the precision of a scalar type, so that a microcontroller
/// converts no numbers at run time. After the last stage, a is zero.
template <class Real>
struct coefficients {
  Real a[tableau::most_stages + 1]{}, b[tableau::most_stages]{}, c[tableau::most_stages]{};
};

template <const tableau& of, class Scalar>
inline constexpr auto coefficients_of = [] {
  using real = std::conditional_t<std::is_same_v<Scalar, float>, float, double>;
  coefficients<real> all;
  for (int s = 0; s < of.stages; ++s) {
    all.a[s] = static_cast<real>(of.at(s).a[0]);
    all.b[s] = static_cast<real>(of.at(s).b[0]);
    all.c[s] = static_cast<real>(of.at(s).c);
  }
  return all;
}();

} // namespace kanexpr::steps
