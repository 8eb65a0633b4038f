// builds: clang++ all
// The benchmark bicycle on tyres: the stiffer they are, the closer it comes to the bicycle that rolls without
// slipping. Meijaard, Papadopoulos, Ruina & Schwab (2007), table 2.
#include <kanexpr/symbolic.hpp>
#include <kanexpr/tyres.hpp>
#include <models/bicycle.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>

namespace {

namespace on_tyres {

using namespace kanexpr;
using namespace kanexpr::units::si;
using namespace bicycle;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"z", meter> z;
constexpr speed<"ux"> ux; // of the center of the rear wheel, in the axes that follow the yaw
constexpr speed<"uy"> uy;
constexpr speed<"uz"> uz;
constexpr parameter<"Ck"> Ck;
constexpr parameter<"Ca"> Ca;
constexpr parameter<"k"> k;

struct O : origin<O, N> {};
struct Rear : offset<Rear, O, x * N::x + y * N::y + z * N::z>,
              velocity<N, ux * Y::x + uy * Y::y + uz * N::z> {};
struct Head : offset<Head, Rear, framelength * Frame::z> {};
struct FrameCenter : offset<FrameCenter, Rear, -framecg1 * Frame::x + framecg3 * Frame::z> {};
struct ForkCenter : offset<ForkCenter, Head, -forkcg1 * Fork::x + forkcg3 * Fork::z> {};
struct Front : offset<Front, Head, forklength * Fork::x + forkoffset * Fork::z> {};

struct RearFrame : rigid_body<RearFrame, FrameCenter, Frame, mframe,
                              inertia<LevelFrame, Iframe11, Iframe22, Iframe33, 0, 0, Iframe31>> {};
struct FrontFork : rigid_body<FrontFork, ForkCenter, Fork, mfork,
                              inertia<LevelFork, Ifork11, Ifork22, Ifork33, 0, 0, Ifork31>> {};
struct RearWheel : rigid_body<RearWheel, Rear, WR, mwr, inertia<Frame, Iwr11, Iwr22, Iwr11>> {};
struct FrontWheel : rigid_body<FrontWheel, Front, WF, mwf, inertia<Fork, Iwf11, Iwf22, Iwf11>> {};

template <class Wheel>
using stiff_tyre =
    tyre<Wheel, flat_ground<O, N::z>, linear_tyre<Ck, Ca>, radial_stiffness<k, 0.0, 1e-12>, standstill<1e-6>>;

struct System
    : kane_system<
          inertial<N>, coordinates<x, y, z, q1, q2, q4, q5>, speeds<ux, uy, uz, u1, u2, u4, u5, u3, u6>,
          kinematics<dot(x) == ux * cos(q1) - uy * sin(q1), dot(y) == ux * sin(q1) + uy * cos(q1),
                     dot(z) == uz, dot(q1) == u1, dot(q2) == u2, dot(q4) == u4, dot(q5) == u5>,
          bodies<RearFrame, FrontFork, RearWheel, FrontWheel>, parameters<Ck, Ca, k>, benchmark_values,
          loads<gravity<-g * N::z>, stiff_tyre<thin_wheel<Rear, Frame::y, WRrad, WR>>,
                stiff_tyre<thin_wheel<Front, Fork::y, WFrad, WF>>>> {};

} // namespace on_tyres

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The places of the states.
enum state { x, y, z, yaw, lean, pitch, steer, ux, uy, uz, u1, u2, u4, u5, u3, u6, states };

class bicycle_on_tyres {
public:
  bicycle_on_tyres() : model_(kanexpr::derive<on_tyres::System>()) {
    EXPECT_EQ(model_.mistake(), "");
    auto linear = model_.linearize();
    rates_ = [f = model_.function(model_.rhs())](const VectorXd& s, const Vector3d& p) mutable -> VectorXd {
      return f(s, p);
    };
    slopes_ = [f = model_.function(linear.explicit_form().A)](
                  const VectorXd& s, const Vector3d& p) mutable -> MatrixXd { return f(s, p); };
  }

  /// A of the lateral motion at a speed: of lean, steer, uy, u1, u2 and u5. The tyres are stiffer by a
  /// factor.
  MatrixXd lateral(double speed, double stiffness) {
    const Vector3d p = stiffness * Vector3d(1e4, 1e4, 1e5);
    const VectorXd at = straight(speed, p);
    const std::array chosen{lean, steer, uy, u1, u2, u5};
    return MatrixXd(slopes_(at, p)(chosen, chosen));
  }

  /// Rolling straight on, with the deflection of the tyres and the spins that make all rates vanish.
  VectorXd straight(double speed, const Vector3d& p) {
    VectorXd at = VectorXd::Zero(states);
    at(z) = 0.3, at(ux) = speed, at(u3) = speed / 0.3, at(u6) = speed / 0.35;
    const std::array unknown{z, pitch, u3, u6}, rates{uz, u4, u3, u6};
    for (int i = 0; i < 8; ++i) {
      const VectorXd missing = rates_(at, p)(rates);
      const MatrixXd jacobian = slopes_(at, p)(rates, unknown);
      at(unknown) -= jacobian.fullPivLu().solve(missing);
    }
    EXPECT_LT(rates_(at, p).tail(9).norm(), 1e-7);
    return at;
  }

private:
  kanexpr::model model_;
  std::function<VectorXd(const VectorXd&, const Vector3d&)> rates_{};
  std::function<MatrixXd(const VectorXd&, const Vector3d&)> slopes_{};
};

using eigenvalue = std::complex<double>;

/// The eigenvalue of a matrix that is nearest to a number.
eigenvalue nearest(const MatrixXd& a, eigenvalue to) {
  const Eigen::VectorXcd all = a.eigenvalues();
  Eigen::Index at = 0;
  (all.array() - to).abs().minCoeff(&at);
  return all(at);
}

/// The speed near a guess at which the real part of the eigenvalue nearest to a number vanishes.
double speed_of_zero(bicycle_on_tyres& b, double stiffness, double guess, eigenvalue near_to) {
  const auto growth = [&](double speed) { return nearest(b.lateral(speed, stiffness), near_to).real(); };
  double before = guess - 0.05, now = guess, at_before = growth(before);
  for (int i = 0; i < 20 && std::abs(now - before) > 1e-13 * now; ++i) {
    const double at_now = growth(now);
    if (at_now == at_before) break;
    const double next = now - at_now * (now - before) / (at_now - at_before);
    before = now, at_before = at_now, now = next;
  }
  return now;
}

TEST(bicycle_on_tyres, tends_to_the_benchmark_as_its_tyres_become_stiff) {
  bicycle_on_tyres b;
  struct transition {
    double speed;
    eigenvalue at;
  };
  for (const transition& known :
       {transition{4.29238253634111, {0, 3.43503384866144}}, transition{6.02426201538837, {0, 0}}}) {
    std::array<double, 4> speeds{}, errors{};
    double stiffness = 30;
    for (std::size_t i = 0; i < 4; ++i, stiffness *= 2) {
      speeds[i] = speed_of_zero(b, stiffness, known.speed, known.at);
      errors[i] = speeds[i] - known.speed;
      if (i > 0) {
        EXPECT_NEAR(errors[i - 1] / errors[i], 2, 0.01);
      }
    }
    std::array<double, 4> better = speeds; // Richardson's extrapolation in 1/stiffness
    for (std::size_t order = 1; order < 4; ++order)
      for (std::size_t i = 3; i >= order; --i)
        better[i] += (better[i] - better[i - 1]) / (std::pow(2.0, order) - 1);
    EXPECT_NEAR(better[3], known.speed, 1e-9);
  }
}

} // namespace
