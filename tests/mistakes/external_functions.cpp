// Functions of the program that models cannot call.
#include "shapes.hpp"

#include <array>
#include <string>

struct wind {
  double operator()(double speed) const { return speed * speed; }
};
struct wind_slope {
  double operator()(double speed) const { return 2 * speed; }
};
struct lift {
  double operator()(double speed, double angle) const { return speed * angle; }
};
struct lift_slopes {
  std::array<double, 2> operator()(double speed, double angle) const { return {angle, speed}; }
};

constexpr external<"wind", wind, wind_slope> air;
constexpr external<"lift", lift, lift_slopes> wing;

// expect: the force at P calls lift with 1 argument; it takes 2
namespace n1 {
struct System : loaded<force<P, wing(u) * N::x>> {};
void f() { use<System>(); }
} // namespace n1

// expect: the torque on A calls wind with 2 arguments; it takes 1
namespace n2 {
struct System : loaded<torque<A, air(u, q) * N::z>> {};
void f() { use<System>(); }
} // namespace n2

// expect: the force at O applies lift to a vector
namespace n3 {
struct System : loaded<force<O, wing(u, N::x) * N::x>> {};
void f() { use<System>(); }
} // namespace n3

// expect: the force at Q calls wind, but a different function of the model has the same name
namespace n4 {
constexpr external<"wind", wind> other;
struct System : loaded<force<P, air(u) * N::x>, force<Q, other(u) * N::x>> {};
void f() { use<System>(); }
} // namespace n4

// expect: the stiffness of the spring between P and O calls texts, which cannot be called with double
// expect: arguments
namespace n5 {
struct texts {
  double operator()(const std::string&) const { return 0; }
};
constexpr external<"texts", texts> written;
struct System : loaded<spring<P, O, written(q), 1>> {};
void f() { use<System>(); }
} // namespace n5

// expect: the force between P and O calls named, which does not return a number
namespace n6 {
struct named {
  std::string operator()(double) const { return {}; }
};
constexpr external<"named", named> written;
struct System : loaded<force_between<P, O, written(q) * N::x>> {};
void f() { use<System>(); }
} // namespace n6

// expect: the force at P calls lift, whose first derivative does not return numbers
namespace n7 {
constexpr external<"lift", lift, wind_slope> half;
struct System : loaded<force<P, half(u, q) * N::x>> {};
void f() { use<System>(); }
} // namespace n7

// expect: the force at O calls lift, whose second derivative does not return numbers
namespace n8 {
constexpr external<"lift", lift, lift_slopes, std::string> bent;
struct System : loaded<force<O, bent(u, q) * N::x>> {};
void f() { use<System>(); }
} // namespace n8

// expect: the torque on A calls 2nd, which is not a valid function name
namespace n9 {
constexpr external<"2nd", wind> second;
struct System : loaded<torque<A, second(u) * N::z>> {};
void f() { use<System>(); }
} // namespace n9

// expect: the derivative of wind is required but not provided; pass it after the function: external<wind,
// expect: function, derivative>
namespace n10 {
constexpr external<"wind", wind> rough;
struct System : loaded<force<P, rough(u) * N::x>> {};
auto f() { return linearization<System>::explicit_form(state<System>(), parameter_values<System>()); }
} // namespace n10

// expect: the second derivative of wind is required but not provided; pass it after the function:
// expect: external<wind, function, derivative, ...>
namespace n11 {
struct System : lagrange_system<inertial<N>, coordinates<q>, bodies<Bob>, loads<potential_energy<air(q)>>> {};
auto f() { return linearization<System>::explicit_form(state<System>(), parameter_values<System>()); }
} // namespace n11

// expect: the force at P contains == inside an expression; use it only once, at the outermost level
namespace n14 {
struct System : loaded<force<P, air(q == 1) * N::x>> {};
void f() { use<System>(); }
} // namespace n14

// expect: the force at O calls sum with more than nine arguments
namespace n16 {
struct sum {
  double operator()(auto... x) const { return (x + ...); }
};
constexpr external<"sum", sum> all;
struct System : loaded<force<O, all(q, q, q, q, q, u, u, u, u, u) * N::x>> {};
void f() { use<System>(); }
} // namespace n16

// expect: the force at Q calls wind, which has more than three derivatives
namespace n15 {
constexpr external<"wind", wind, wind_slope, wind_slope, wind_slope, wind_slope> often;
struct System : loaded<force<Q, often(u) * N::x>> {};
void f() { use<System>(); }
} // namespace n15

// expect: the force at Q calls both, whose first derivative does not return numbers
namespace n17 {
struct product {
  double operator()(double x, double y) const { return x * x * y; }
};
struct by_first {
  double operator()(double x, double y) const { return 2 * x * y; }
};
constexpr external<"both", product, by_first> both;
struct System : loaded<force<Q, both(u, q) * N::x>> {};
void f() { use<System>(); }
} // namespace n17

// expect: the force at P calls rounded, which returns integers, not double
namespace n18 {
struct to_whole {
  int operator()(double x) const { return static_cast<int>(x); }
};
constexpr external<"rounded", to_whole> rounded;
struct System : loaded<force<P, rounded(u) * N::x>> {};
void f() { use<System>(); }
} // namespace n18

// expect: the force at P calls rounded, which returns float, not double
namespace n19 {
struct to_short {
  float operator()(auto x) const { return static_cast<float>(x); }
};
constexpr external<"rounded", to_short> rounded;
struct System : loaded<force<P, rounded(u) * N::x>> {};
void f() { use<System>(); }
} // namespace n19

// expect: the torque on A calls steps, which takes integers, not double
namespace n20 {
struct of_whole {
  double operator()(double x, int n) const { return x * n; }
};
constexpr external<"steps", of_whole> steps;
struct System : loaded<torque<A, steps(u, q) * N::z>> {};
void f() { use<System>(); }
} // namespace n20

// expect: the force at O calls wind, whose first derivative returns integers, not double
namespace n21 {
constexpr auto slope = [](double) { return 2; };
constexpr external<"wind", wind, decltype(slope)> air_of_whole;
struct System : loaded<force<O, air_of_whole(u) * N::x>> {};
void f() { use<System>(); }
} // namespace n21

// expect: the force at O calls lift, whose first derivative takes float, not double
namespace n22 {
struct slopes {
  std::array<double, 2> operator()(float speed, const float& angle) const noexcept { return {angle, speed}; }
};
constexpr external<"lift", lift, slopes> wing_of_float;
struct System : loaded<force<O, wing_of_float(u, q) * N::x>> {};
void f() { use<System>(); }
} // namespace n22

// expect: the force at Q calls both, whose second derivative returns float, not double
namespace n23 {
struct curvatures {
  std::array<std::array<float, 2>, 2> operator()(double, double) const { return {{{0, 1}, {1, 0}}}; }
};
constexpr external<"both", lift, lift_slopes, curvatures> both;
struct System : loaded<force<Q, both(u, q) * N::x>> {};
void f() { use<System>(); }
} // namespace n23
