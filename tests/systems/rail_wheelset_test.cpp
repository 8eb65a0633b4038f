// builds: clang++ all
// A wheelset with conical wheels on two rails: its slow motion is that of Klingel, Organ für die Fortschritte
// des Eisenbahnwesens 38 (1883), pages 113-123.
#include <kanexpr/symbolic.hpp>
#include <kanexpr/tyres.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

namespace {

namespace wheelset {

using namespace kanexpr;

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr coordinate<"z"> z;
constexpr coordinate<"psi"> psi;
constexpr coordinate<"phi"> phi;
constexpr speed<"ux"> ux;
constexpr speed<"uy"> uy;
constexpr speed<"uz"> uz;
constexpr speed<"upsi"> upsi;
constexpr speed<"uphi"> uphi;
constexpr speed<"w"> w; // spin
constexpr parameter<"r"> r;
constexpr parameter<"b"> b; // half of the distance between the wheels and between the contact points
constexpr parameter<"lambda"> lambda;
constexpr parameter<"R"> head;
constexpr parameter<"f"> f; // creep coefficient
constexpr parameter<"k"> k;

struct N : inertial_frame<N> {};
struct Yaw : rotated<Yaw, N, psi, N::z> {};
struct Roll : rotated<Roll, Yaw, phi, Yaw::x> {};
struct Set : rotated<Set, Roll, 0, Roll::y>, angular_velocity<Roll, w * Roll::y> {};

// The point of a head below the contact is at the distance R sin(atan λ).
constexpr auto sine = lambda / sqrt(1 + lambda * lambda);

struct O : origin<O, N> {};
struct G : offset<G, O, x * N::x + y * N::y + z * N::z> {};
struct Left : offset<Left, G, b * Roll::y> {};
struct Right : offset<Right, G, -b * Roll::y> {};
struct LeftRail : offset<LeftRail, O, (b + head * sine) * N::y> {};
struct RightRail : offset<RightRail, O, -(b + head * sine) * N::y> {};

struct Wheelset : rigid_body<Wheelset, G, Set, 1000, inertia<Roll, 600, 100, 600>> {};

template <class Wheel, class Rail>
using creeping = tyre<Wheel, straight_rail<Rail, N::x, N::z, head>, linear_tyre<f, f>,
                      radial_stiffness<k, 0.0, 1e-12>, standstill<1e-12>>;

struct System
    : kane_system<
          inertial<N>, coordinates<x, y, z, psi, phi>, speeds<ux, uy, uz, upsi, uphi, w>,
          kinematics<dot(x) == ux, dot(y) == uy, dot(z) == uz, dot(psi) == upsi, dot(phi) == uphi>,
          bodies<Wheelset>, parameters<r, b, lambda, head, f, k>,
          loads<gravity<-0.01 * N::z>, creeping<conical_wheel<Left, Roll::y, r, -lambda, Set>, LeftRail>,
                creeping<conical_wheel<Right, Roll::y, r, lambda, Set>, RightRail>>> {};

} // namespace wheelset

using Eigen::MatrixXd;
using Eigen::VectorXd;
enum state { x, y, z, psi, phi, ux, uy, uz, upsi, uphi, w, states };

// A section through both wheels rotates about the intersection of the normals at the contact points, at the
// height b/λ. This yields the rates of y and ψ of a wheelset that rolls without slipping, ẏ = V ψ (1 − λ r/b)
// and ψ̇ = −V λ (b + R sin atan λ)/(b − λ r) y/(r b).
double klingel(double speed, double r, double b, double lambda, double head) {
  const double sine = lambda / std::hypot(1, lambda);
  return speed * std::sqrt(lambda * (1 + head * sine / b) / (r * b));
}

TEST(wheelset, of_cones_has_the_wavelength_of_klingel) {
  kanexpr::model model = kanexpr::derive<wheelset::System>();
  ASSERT_EQ(model.mistake(), "");
  auto rhs = model.function(model.rhs());
  const auto rates = [&](const VectorXd& at, const VectorXd& p) -> VectorXd { return rhs(at, p); };
  auto slopes = model.function(model.linearize().explicit_form().A);
  constexpr double r = 0.45, b = 0.75, speed = 1;
  for (const double head : {0.0, 0.3})
    for (const double lambda : {0.05, 0.15}) {
      VectorXd p(6), at = VectorXd::Zero(states);
      p << r, b, lambda, head, 1e10, 1e10;
      at(ux) = speed, at(w) = speed / r;
      const double sine = lambda / std::hypot(1, lambda);
      at(z) = r - head * (1 - std::sqrt(1 - sine * sine));
      const std::array unknown{z, w}, vanish{uz, w};
      for (int i = 0; i < 6; ++i) {
        const MatrixXd jacobian = slopes(at, p)(vanish, unknown);
        at(unknown) -= jacobian.fullPivLu().solve(rates(at, p)(vanish));
      }
      EXPECT_LT(rates(at, p).tail(6).norm(), 1e-6);
      const std::array chosen{y, psi, phi, uy, upsi, uphi};
      const MatrixXd lateral = slopes(at, p)(chosen, chosen);
      const std::complex<double> known(0, klingel(speed, r, b, lambda, head));
      const double away = (lateral.eigenvalues().array() - known).abs().minCoeff();
      EXPECT_LT(away, 2e-7 * std::abs(known)) << head << " " << lambda;
    }
}

} // namespace
