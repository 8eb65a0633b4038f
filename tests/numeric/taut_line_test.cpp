// builds: clang++
// Lines around surfaces for drawing: their lengths are those of geodesics, and they touch the surface.
#include <kanexpr/numeric/taut_line.hpp>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace {

using namespace kanexpr::numeric;
using Eigen::Vector3d;

/// The length of a line if its parts on the surface are arcs of circles, like those of a cylinder or sphere
/// without advance along the axis.
double length_of(const taut_line& line, double radius) {
  double sum = 0;
  std::size_t straight = 0;
  for (std::size_t i = 0; i + 1 < line.places.size(); ++i) {
    const double chord = (line.places[i + 1] - line.places[i]).norm();
    const bool is_straight = straight < line.straight_parts.size() && line.straight_parts[straight] == i;
    straight += is_straight ? 1 : 0;
    sum += is_straight ? chord : 2 * radius * std::asin(chord / (2 * radius));
  }
  return sum;
}

TEST(taut_line, around_a_cylinder_has_tangents_and_an_arc) {
  wrapped_surface drum{.center = {1, 2, 3}, .axis = Vector3d(1, 2, 2) / 3, .size = 0.5};
  const Vector3d x = drum.axis.unitOrthogonal(), y = drum.axis.cross(x);
  for (const int sense : {1, -1}) {
    drum.sense = sense;
    const Vector3d first = drum.center + 1.3 * x, last = drum.center - 0.9 * x + sense * 0.2 * y;
    const taut_line line = line_around(drum, first, last);
    ASSERT_EQ(line.places.size(), parts_on_surface + 3);
    EXPECT_EQ(line.straight_parts, (std::vector<std::size_t>{0, parts_on_surface + 1}));
    const double tangents = std::sqrt(1.69 - 0.25) + std::sqrt(0.85 - 0.25);
    const double turned = std::numbers::pi - std::atan2(0.2, 0.9);
    const double angle = turned - std::acos(0.5 / 1.3) - std::acos(0.5 / std::sqrt(0.85));
    EXPECT_NEAR(length_of(line, 0.5), tangents + 0.5 * angle, 1e-12) << sense;
    for (std::size_t i = 1; i + 1 < line.places.size(); ++i) {
      const Vector3d away = line.places[i] - drum.center;
      EXPECT_NEAR((away - away.dot(drum.axis) * drum.axis).norm(), 0.5, 1e-12);
    }
    const Vector3d touching = line.places[1] - drum.center, tangent = line.places[1] - first;
    EXPECT_NEAR(touching.dot(tangent), 0, 1e-12);
    EXPECT_GT(sense * drum.axis.dot(touching.cross(line.places[2] - line.places[1])), 0);
  }
}

/// On a helix, the height grows in proportion to the length across the axis.
TEST(taut_line, around_a_cylinder_is_a_helix) {
  const wrapped_surface drum{.size = 1, .first_is_on_surface = true, .last_is_on_surface = true};
  const taut_line line = line_around(drum, {1, 0, 0}, {0, -1, 2});
  ASSERT_EQ(line.places.size(), parts_on_surface + 1);
  EXPECT_TRUE(line.straight_parts.empty());
  for (std::size_t i = 0; i < line.places.size(); ++i) {
    const double part = static_cast<double>(i) / 12, angle = 1.5 * std::numbers::pi * part;
    EXPECT_LT((line.places[i] - Vector3d(std::cos(angle), std::sin(angle), 2 * part)).norm(), 1e-12);
  }
}

TEST(taut_line, is_straight_if_it_does_not_touch) {
  const wrapped_surface drum{.size = 0.5};
  const taut_line line = line_around(drum, {2, -1, 0}, {2, 1, 0.3});
  ASSERT_EQ(line.places.size(), parts_on_surface + 3);
  for (const Vector3d& place : line.places)
    EXPECT_LT((place - Vector3d(2, -1, 0)).cross(Vector3d(0, 2, 0.3)).norm(), 1e-12);
}

TEST(taut_line, around_a_sphere_is_on_a_great_circle) {
  const wrapped_surface ball{.form = wrapped_solid::sphere, .center = {0, 0, 1}, .size = 0.4};
  const Vector3d first = ball.center + Vector3d(1, 0, 0), last = ball.center + Vector3d(-0.7, 0.3, 0.1);
  const taut_line line = line_around(ball, first, last);
  const double between = std::acos(-0.7 / (last - ball.center).norm());
  const double far = (last - ball.center).norm();
  const double angle = between - std::acos(0.4) - std::acos(0.4 / far);
  EXPECT_NEAR(length_of(line, 0.4), std::sqrt(1 - 0.16) + std::sqrt(far * far - 0.16) + 0.4 * angle, 1e-12);
  const Vector3d normal = Vector3d(1, 0, 0).cross(last - ball.center);
  for (const Vector3d& place : line.places) EXPECT_NEAR(normal.dot(place - ball.center), 0, 1e-12);
}

/// The places on a cone are on a straight line of its development.
TEST(taut_line, around_a_cone_is_straight_in_the_development) {
  const double half_angle = 0.35;
  const wrapped_surface cone{.form = wrapped_solid::cone, .size = half_angle, .sense = -1};
  const Vector3d first(0.8, 0.1, 1), last(-0.5, 0.6, 1.7);
  const taut_line line = line_around(cone, first, last);
  ASSERT_EQ(line.places.size(), parts_on_surface + 3);
  std::vector<Eigen::Vector2d> developed;
  double angle = 0;
  for (std::size_t i = 1; i + 1 < line.places.size(); ++i) {
    const Vector3d place = line.places[i];
    EXPECT_NEAR(std::atan2(place.head<2>().norm(), place.z()), half_angle, 1e-12);
    if (i > 1) {
      const Vector3d before = line.places[i - 1];
      angle += std::sin(half_angle) * -std::atan2(before.x() * place.y() - before.y() * place.x(),
                                                  before.head<2>().dot(place.head<2>()));
    }
    developed.emplace_back(place.norm() * std::cos(angle), place.norm() * std::sin(angle));
  }
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  for (const Eigen::Vector2d& place : developed)
    EXPECT_NEAR(cross(place - developed.front(), developed.back() - developed.front()), 0, 1e-12);
  // The tangents continue this line: they meet the rulings at the same angles.
  const auto along_ruling = [](const Vector3d& from, const Vector3d& to, const Vector3d& ruling) {
    return (to - from).normalized().dot(ruling.normalized());
  };
  const Eigen::Vector2d direction = (developed.back() - developed.front()).normalized();
  EXPECT_NEAR(along_ruling(first, line.places[1], line.places[1]),
              direction.dot(developed.front().normalized()), 1e-12);
  EXPECT_NEAR(along_ruling(line.places[parts_on_surface + 1], last, line.places[parts_on_surface + 1]),
              direction.dot(developed.back().normalized()), 1e-12);
  // They are tangent to the cone.
  for (const auto& [from, at] :
       {std::pair(first, line.places[1]), std::pair(last, line.places[parts_on_surface + 1])}) {
    const Vector3d outward = Vector3d(at.x(), at.y(), 0).normalized() * std::cos(half_angle) -
                             Vector3d::UnitZ() * std::sin(half_angle);
    EXPECT_NEAR(outward.dot(at - from), 0, 1e-12);
  }
}

} // namespace
