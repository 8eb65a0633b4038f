// builds: clang++ all
// Compiled systems of masses on springs and dampers, compared with M ü + C u̇ + K x = 0 and with Newton's
// law.
#include "no_heap.hpp"

#include <kanexpr/kanexpr.hpp>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace kanexpr;
using Eigen::Matrix2d;
using Eigen::Vector2d;

std::mt19937 random_source(3);
double some(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_source);
}

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};

namespace chain {

template <int i>
constexpr coordinate<"x", i> x;
template <int i>
constexpr speed<"u", i> u;
template <int i>
constexpr parameter<"m", i> m;
template <int i>
constexpr parameter<"k", i> k;
template <int i>
constexpr parameter<"c", i> c;
template <int i>
constexpr parameter<"l", i> l;

template <int i>
struct Place : offset<Place<i>, O, x<i> * N::x> {};
template <int i>
struct Mass : particle<Mass<i>, Place<i>, m<i>> {};

struct System
    : kane_system<inertial<N>, coordinates<x<1>, x<2>>, speeds<u<1>, u<2>>,
                  kinematics<dot(x<1>) == u<1>, dot(x<2>) == u<2>>,
                  parameters<m<1>, m<2>, k<1>, k<2>, c<1>, c<2>, l<1>, l<2>>, bodies<Mass<1>, Mass<2>>,
                  loads<spring<O, Place<1>, k<1>, l<1>>, damper<O, Place<1>, c<1>>,
                        spring<Place<1>, Place<2>, k<2>, l<2>>, damper<Place<1>, Place<2>, c<2>>>> {};

} // namespace chain

TEST(springs, of_a_chain_of_masses) {
  using eom = equations_of_motion<chain::System>;
  for (int state = 0; state < 20; ++state) {
    eom::parameters p;
    for (double& value : p) value = some(0.3, 2);
    const double k1 = p(2), k2 = p(3), c1 = p(4), c2 = p(5), l1 = p(6), l2 = p(7);
    const Matrix2d mass = p.head<2>().asDiagonal();
    Matrix2d stiffness, damping;
    stiffness << k1 + k2, -k2, -k2, k2;
    damping << c1 + c2, -c2, -c2, c2;
    const Vector2d at_rest(l1, l1 + l2);
    const Vector2d x(some(0.2, 1), some(1.2, 3)), u(some(-2, 2), some(-2, 2)); // in order, as at rest
    eom::state now;
    now << x, u;

    const no_heap::guard guard;
    const Vector2d expected = -(stiffness * (x - at_rest) + damping * u), udot = eom::udot(now, p);
    EXPECT_LT((eom::mass_matrix(now, p) - mass).norm(), 1e-14);
    EXPECT_LT((eom::forcing(now, p) - expected).norm(), 1e-12 * (1 + expected.norm()));
    EXPECT_LT((mass * udot - expected).norm(), 1e-12 * (1 + expected.norm()));
    const double energy = (x - at_rest).dot(stiffness * (x - at_rest)) / 2;
    EXPECT_NEAR(eom::potential_energy(now, p), energy, 1e-12 * (1 + energy));
  }
}

namespace pendulum {

constexpr coordinate<"r"> r; // the length of the first spring, and its direction
constexpr coordinate<"q"> q;
constexpr coordinate<"x"> x; // of the second bob relative to the first
constexpr coordinate<"y"> y;
constexpr speed<"v"> v;
constexpr speed<"w"> w;
constexpr speed<"vx"> vx;
constexpr speed<"vy"> vy;
constexpr double m1 = 1.3, m2 = 0.7, k1 = 40, k2 = 25, l1 = 0.8, l2 = 0.5, drag = 0.3;

struct A : rotated<A, N, q, N::z> {};
struct First : offset<First, O, r * A::x> {};
struct Second : offset<Second, First, x * N::x + y * N::y> {};
struct Bob1 : particle<Bob1, First, m1> {};
struct Bob2 : particle<Bob2, Second, m2> {};

struct System
    : kane_system<inertial<N>, coordinates<r, q, x, y>, speeds<v, w, vx, vy>,
                  kinematics<dot(r) == v, dot(q) == w, dot(x) == vx, dot(y) == vy>, bodies<Bob1, Bob2>,
                  loads<gravity<9.81 * N::x>, spring<O, First, k1, l1>, spring<Second, First, k2, l2>,
                        force<Second, -drag * velocity_of<Second>>>> {};

} // namespace pendulum

// Two bobs on springs, one below the other, the lower one in air.
TEST(springs, of_a_double_pendulum) {
  using namespace pendulum;
  using eom = equations_of_motion<System>;
  for (int state = 0; state < 20; ++state) {
    eom::state now;
    now << some(0.4, 1.2), some(-2, 2), some(0.2, 1), some(-1, 1), some(-2, 2), some(-2, 2), some(-2, 2),
        some(-2, 2);
    const double length = now(0), cos = std::cos(now(1)), sin = std::sin(now(1));
    const Vector2d along(cos, sin), across(-sin, cos), between(now(2), now(3)), rate(now(6), now(7));
    const Vector2d velocity = now(4) * along + length * now(5) * across;
    const Vector2d pull = k2 * (between.norm() - l2) * between.normalized(), g(9.81, 0);
    const Vector2d first = g + (pull - k1 * (length - l1) * along) / m1;
    const Vector2d second = g - (pull + drag * (velocity + rate)) / m2;
    Eigen::Vector4d expected;
    expected << first.dot(along) + length * now(5) * now(5),
        (first.dot(across) - 2 * now(4) * now(5)) / length, second - first;

    const no_heap::guard guard;
    const Eigen::Vector4d udot = eom::udot(now);
    EXPECT_LT((udot - expected).norm(), 1e-12 * expected.norm());
    // the energy lost goes to the air
    const double energy = k1 * std::pow(length - l1, 2) / 2 + k2 * std::pow(between.norm() - l2, 2) / 2 -
                          9.81 * (m1 * length * cos + m2 * (length * cos + now(2)));
    EXPECT_NEAR(eom::potential_energy(now), energy, 1e-12 * (10 + std::abs(energy)));
  }
}

} // namespace
