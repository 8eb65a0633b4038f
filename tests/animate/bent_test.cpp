// builds: clang++ all
// Pictures of beams: the stations are those of its sections, and what is wrong is reported.
#include "animate/samples.hpp"

#include <kanexpr/animate.hpp>
#include <kanexpr/beams.hpp>
#include <kanexpr/kanexpr.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace {

using namespace kanexpr;

constexpr coordinate<"angle"> angle;
constexpr speed<"spin"> spin;
constexpr parameter<"L"> L;
constexpr parameter<"rho"> rho;
constexpr parameter<"EI"> EI;

struct N : inertial_frame<N> {};
struct R : rotated<R, N, angle, N::z> {};
struct O : origin<O, N> {};
struct Root : offset<Root, O, 0.2 * R::x> {};
struct Blade : beam<Blade, Root, R::x, L, rho, bending<R::y, EI, polynomial<0, 0, 1>>> {};
struct System : kane_system<inertial<N>, coordinates<angle>, speeds<spin>, kinematics<dot(angle) == spin>,
                            bodies<Blade>> {};

template <class... Elements>
constexpr std::string_view mistake_in() {
  return picture<System, up<N::z>, Elements...>::mistake.view();
}

/// The deflection is q ξ², the foreshortening ½ ∫ (2 ξ q/L)² dx, and the slope 2 ξ q/L.
TEST(bent, has_the_sections_of_its_beam) {
  using shown =
      picture<System, up<N::z>, show<bent<Blade, tapered<rectangle<L / 9, 0.02>, rectangle<0.1, 0.01>>, 5>>>;
  tests::samples<System> run;
  run.p = {{L, 2}, {rho, 1}, {EI, 1}};
  const double q = 0.3, turned = 0.6;
  run.all.push_back({0, {{angle, turned}, {Blade::q<0>, q}, {spin, 0}, {Blade::u<0>, 0}}, {}});
  const animation a = animated<shown>(run);
  ASSERT_TRUE(a) << a.cause();
  const animation::shape* blade = a.find("beam Blade");
  ASSERT_NE(blade, nullptr);
  EXPECT_EQ(blade->profile, "rectangle");
  ASSERT_EQ(blade->places, 5u);
  const Eigen::Vector3d x(std::cos(turned), std::sin(turned), 0), y(-std::sin(turned), std::cos(turned), 0);
  for (std::size_t i = 0; i < 5; ++i) {
    const double xi = static_cast<double>(i) / 4;
    const double along = 0.2 + 2 * xi - 2 * q * q * xi * xi * xi / 3 / 2, slope = 2 * xi * q / 2;
    const Eigen::Vector3d place = along * x + q * xi * xi * y;
    const Eigen::Vector3d tangent = std::cos(slope) * x + std::sin(slope) * y;
    const Eigen::Vector3d across = std::cos(slope) * y - std::sin(slope) * x;
    const animate::placement& here = blade->placement_at(0, i);
    EXPECT_LT((here.position - place).norm(), 1e-14);
    EXPECT_LT((here.orientation.col(2) - tangent).norm(), 1e-14);
    EXPECT_LT((here.orientation.col(0) - across).norm(), 1e-14);
    const animate::placement& straight = blade->undeformed.at(i);
    EXPECT_LT((straight.position - (0.2 + 2 * xi) * x).norm(), 1e-14);
    EXPECT_LT((straight.orientation.col(2) - x).norm(), 1e-14);
  }
}

struct Shapeless : beam<Shapeless, Root, R::x, L, rho> {};

TEST(bent, wants_a_beam_a_profile_and_two_stations) {
  EXPECT_EQ((mistake_in<show<bent<R, circle<1>>>>()), "the picture bends R, which is not a beam");
  EXPECT_EQ((mistake_in<show<bent<Shapeless, circle<1>>>>()), "the beam Shapeless has no shapes");
  EXPECT_EQ((mistake_in<show<bent<Blade, R>>>()),
            "the profile of the beam Blade is R; it must be a profile such as circle<radius>");
  EXPECT_EQ((mistake_in<show<bent<Blade, circle<1>, 1>>>()),
            "the beam Blade has one station; it needs at least two");
  EXPECT_EQ((mistake_in<show<bent<Blade, circle<angle>>>>()),
            "the radius of the beam Blade contains the coordinate angle; it may depend only on parameters");
  EXPECT_EQ(
      (mistake_in<show<bent<Blade, tapered<circle<1>, rectangle<1, 1>>>>>()),
      "the profile of the beam Blade changes from circle to rectangle; both ends must have the same form");
}

} // namespace
