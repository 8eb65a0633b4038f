// builds: clang++
// Frames described by modified Rodrigues parameters, compared with unit quaternions and with the matrix in
// the book.
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic.hpp>

#include "models/pivot_body.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace turned {

using namespace pivot_body;

constexpr coordinate<"s1"> s1;
constexpr coordinate<"s2"> s2;
constexpr coordinate<"s3"> s3;

struct B : modified_rodrigues<B, N, s1, s2, s3>,
           angular_velocity<N, u1 * own::x + u2 * own::y + u3 * own::z> {};
struct G : offset<G, O, a * B::x + b * B::y + c * B::z> {};
struct Body : rigid_body<Body, G, B, m, inertia<B, Ixx, Iyy, Izz, Ixy>> {};

/// The body of pivot_body.hpp.
template <class... More>
struct system
    : kane_system<inertial<N>, coordinates<s1, s2, s3>, speeds<u1, u2, u3>, kinematics<kinematics_of<B, N>>,
                  inputs<T1, T2, T3>, bodies<Body>,
                  loads<gravity<-g * N::z>, torque<B, T1 * B::x + T2 * B::y + T3 * B::z>>, More...> {};
struct System : system<> {};

// Rates as speeds: the angular velocity follows from the orientation.
struct Free : modified_rodrigues<Free, N, s1, s2, s3> {};
struct Center : offset<Center, O, a * Free::x + b * Free::y + c * Free::z> {};
struct Whole : rigid_body<Whole, Center, Free, m, inertia<Free, Ixx, Iyy, Izz, Ixy>> {};
struct ByLagrange
    : lagrange_system<inertial<N>, coordinates<s1, s2, s3>, parameters<m, Ixx, Iyy, Izz, Ixy, a, b, c, g>,
                      inputs<T1, T2, T3>, bodies<Whole>,
                      loads<gravity<-g * N::z>, torque<Free, T1 * Free::x + T2 * Free::y + T3 * Free::z>>> {};

} // namespace turned

namespace {

using namespace kanexpr;
using Eigen::Matrix3d;
using Eigen::Vector3d;

using of_quaternion = equations_of_motion<pivot_body::System>;
using of_parameters = equations_of_motion<turned::System>;

Matrix3d cross_product(const Vector3d& s) {
  Matrix3d m;
  m << 0, -s(2), s(1), s(2), 0, -s(0), -s(1), s(0), 0;
  return m;
}

/// The same state, in both descriptions.
struct sample {
  explicit sample(unsigned seed) {
    std::mt19937_64 source(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    e = Eigen::Vector4d::NullaryExpr([&] { return any(source); }).normalized();
    sigma = e.tail<3>() / (1 + e(0));
    speeds = Vector3d::NullaryExpr([&] { return 2 * any(source); });
    r = Vector3d::NullaryExpr([&] { return any(source); });
    x << e, speeds;
    y << sigma, speeds;
  }
  Eigen::Vector4d e;
  Vector3d sigma, speeds, r;
  of_quaternion::state x;
  of_parameters::state y;
};

template <class Eom>
typename Eom::parameters parameters_of() {
  using namespace pivot_body;
  return {{m, 2}, {Ixx, 0.3}, {Iyy, 0.4}, {Izz, 0.5}, {Ixy, -0.05}, {g, 9.81}, {a, 0.2}, {b, -0.1}, {c, 0.4}};
}

const auto p = parameters_of<of_quaternion>();
const auto same_p = parameters_of<of_parameters>();

TEST(modified_rodrigues, turn_as_the_matrix_of_the_book) {
  constexpr function<turned::System, in_axes_of<turned::B>(turned::N::x), in_axes_of<turned::B>(turned::N::y),
                     in_axes_of<turned::B>(turned::N::z)>
      axes{};
  for (unsigned seed = 0; seed < 20; ++seed) {
    const sample at(seed);
    const Matrix3d cross = cross_product(at.sigma);
    const double square = at.sigma.squaredNorm();
    const Matrix3d expected =
        Matrix3d::Identity() + (8 * cross * cross - 4 * (1 - square) * cross) / ((1 + square) * (1 + square));
    const auto [x, y, z] = axes(at.y, same_p, at.r);
    Matrix3d found;
    found << Vector3d(x), Vector3d(y), Vector3d(z);
    EXPECT_LT((found - expected).norm(), 1e-14);
  }
}

TEST(modified_rodrigues, give_the_motion_of_the_quaternion) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const sample at(seed);
    const Vector3d found = of_parameters::udot(at.y, same_p, at.r),
                   expected = of_quaternion::udot(at.x, p, at.r);
    EXPECT_LT((found - expected).norm(), 1e-12 * (1 + expected.norm()));
    const double energy = of_quaternion::potential_energy(at.x, p);
    EXPECT_NEAR(of_parameters::potential_energy(at.y, same_p), energy, 1e-13);
    // σ = e / (1 + e0)
    const Eigen::Vector4d rate = of_quaternion::qdot(at.x, p);
    const double below = 1 + at.e(0);
    const Vector3d of_sigma = rate.tail<3>() / below - at.e.tail<3>() * rate(0) / (below * below);
    EXPECT_LT((of_parameters::qdot(at.y, same_p) - of_sigma).norm(), 1e-13 * (1 + of_sigma.norm()));
  }
}

TEST(modified_rodrigues, have_kinematic_equations_that_are_always_regular) {
  const of_parameters::state rest{{turned::s1, 0}, {turned::s2, 0},  {turned::s3, 0},
                                  {turned::u1, 4}, {turned::u2, -8}, {turned::u3, 12}};
  EXPECT_EQ(of_parameters::qdot(rest, same_p), Vector3d(1, -2, 3));
  EXPECT_EQ(of_parameters::cost(of_parameters::qdot).divisions, 0);
}

// The ω that follows from the orientation equals the declared one.
TEST(modified_rodrigues, have_the_angular_velocity_of_their_rates) {
  using eom = equations_of_motion<turned::ByLagrange>;
  constexpr function<turned::ByLagrange, in_axes_of<turned::Free>(angular_velocity_of<turned::Free>)>
      turning{};
  for (unsigned seed = 0; seed < 20; ++seed) {
    const sample at(seed);
    eom::state rates;
    rates << at.sigma, Vector3d(of_parameters::qdot(at.y, same_p));
    const auto own = parameters_of<eom>();
    EXPECT_LT((Vector3d(turning(rates, own, at.r)) - at.speeds).norm(), 1e-12 * (1 + at.speeds.norm()));
    EXPECT_NEAR(eom::kinetic_energy(rates, own), of_quaternion::kinetic_energy(at.x, p), 1e-12);
  }
}

TEST(modified_rodrigues, of_the_builder_are_the_same) {
  runtime::builder b("N");
  std::vector<symbolic::expression> s, u;
  for (const char* name : {"s1", "s2", "s3"}) s.push_back(b.coordinate(name));
  for (const char* name : {"u1", "u2", "u3"}) u.push_back(b.speed(name));
  const auto frame = b.modified_rodrigues("B", b.inertial_frame(), s[0], s[1], s[2]);
  b.angular_velocity(frame, b.inertial_frame(), b.along(frame, u[0], u[1], u[2]));
  b.kinematics_of(frame, b.inertial_frame());
  b.rigid_body("Body", b.origin("O"), frame, b.number(1), b.inertia(frame, 1, 2, 2.5));
  auto built = derive(b);
  EXPECT_EQ(built.mistake(), "");
  auto derived = derive<turned::System>();
  EXPECT_EQ(symbolic::print(built.qdot()), symbolic::print(derived.qdot()));
}

} // namespace
