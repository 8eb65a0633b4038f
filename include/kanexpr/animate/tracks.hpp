#pragma once

#include <kanexpr/animate/animation.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// The motions that the shapes of an animation share. Most shapes are parts of a few rigid bodies, so a page
/// stores one pose for each body and time, and for each shape its constant place in the body. The bodies are
/// found from the placements themselves, whatever their source.
namespace kanexpr::animate {

/// The path of a point, or the poses of a rigid body, at all times.
struct track {
  Eigen::Matrix3Xd positions{};
  std::vector<Eigen::Matrix3d> orientations{}; ///< empty for a point

  bool is_body() const { return !orientations.empty(); }
};

/// A point or a frame that is fixed in the body of a track.
struct anchor {
  std::size_t track = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d orientation = Eigen::Matrix3d::Identity();
};

/// The tracks of an animation. The anchors of a shape are its places or poses, or its two ends; the second
/// anchor of an arrow is the track of its vector.
struct tracks {
  std::vector<track> all{};
  std::vector<std::vector<anchor>> of_shape{};
  /// The anchors while no flexible body is deformed; empty if they are the same.
  std::vector<std::vector<anchor>> undeformed{};
};

namespace detail {

/// Differences below the seven digits that a page stores are ignored.
inline constexpr double relative_tolerance = 5e-8;

/// The place of a path in a body if it does not move there.
inline std::optional<Eigen::Vector3d> place_in(const track& body, const Eigen::Matrix3Xd& path,
                                               double tolerance) {
  std::optional<Eigen::Vector3d> first;
  for (Eigen::Index k = 0; k < path.cols(); ++k) {
    const Eigen::Vector3d here =
        body.orientations[static_cast<std::size_t>(k)].transpose() * (path.col(k) - body.positions.col(k));
    if (!first) first = here;
    if ((here - *first).lpNorm<Eigen::Infinity>() > tolerance) return {};
  }
  return first;
}

inline bool keeps_orientation(const track& body, const track& other) {
  const Eigen::Matrix3d first = body.orientations[0].transpose() * other.orientations[0];
  for (std::size_t k = 0; k < body.orientations.size(); ++k)
    if ((body.orientations[k].transpose() * other.orientations[k] - first).lpNorm<Eigen::Infinity>() >
        2 * relative_tolerance)
      return false;
  return true;
}

inline bool keep_distance(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b, double tolerance) {
  const double first = (a.col(0) - b.col(0)).norm();
  for (Eigen::Index k = 1; k < a.cols(); ++k)
    if (std::abs((a.col(k) - b.col(k)).norm() - first) > tolerance) return false;
  return true;
}

/// A body with its origin at the first of three points, and the other two in its xy plane.
inline track body_of(const Eigen::Matrix3Xd& origin, const Eigen::Matrix3Xd& along_x,
                     const Eigen::Matrix3Xd& in_plane) {
  track body{origin, {}};
  for (Eigen::Index k = 0; k < origin.cols(); ++k) {
    const Eigen::Vector3d x = (along_x.col(k) - origin.col(k)).normalized();
    const Eigen::Vector3d z = x.cross(in_plane.col(k) - origin.col(k)).normalized();
    Eigen::Matrix3d axes;
    axes.col(0) = x, axes.col(1) = z.cross(x), axes.col(2) = z;
    body.orientations.push_back(axes);
  }
  return body;
}

/// Finds the rigid bodies, first from shapes with an orientation, then from triangles of points.
class track_finder {
public:
  explicit track_finder(const animation& a) : from_(a), times_(static_cast<Eigen::Index>(a.times.size())) {
    double largest = 0;
    for (const animation::shape& s : a.shapes)
      for (const placement& here : s.placements)
        largest = (std::max)({largest, here.position.lpNorm<Eigen::Infinity>(),
                              is_arrow(s) ? 0.0 : here.end.lpNorm<Eigen::Infinity>()});
    tolerance_ = relative_tolerance * largest;
  }

  tracks find() {
    bodies_.push_back({Eigen::Matrix3Xd::Zero(3, times_),
                       std::vector<Eigen::Matrix3d>(from_.times.size(), Eigen::Matrix3d::Identity())});
    const std::vector<animation::shape> straight = undeformed_shapes();
    for (const std::vector<animation::shape>* all : {&from_.shapes, &straight})
      for (const animation::shape& s : *all) read(s);
    find_triangles();
    for (const animation::shape& s : from_.shapes) found_.of_shape.push_back(anchors_of(s));
    for (const animation::shape& s : straight)
      found_.undeformed.push_back(s.placements.empty() ? std::vector<anchor>() : anchors_of(s));
    return std::move(found_);
  }

private:
  static bool is_arrow(const animation::shape& s) { return s.kind == "arrow"; }

  /// The shapes with their undeformed placements. Of an arrow, only its place can be undeformed.
  std::vector<animation::shape> undeformed_shapes() const {
    std::vector<animation::shape> all;
    for (const animation::shape& s : from_.shapes) {
      animation::shape& straight = all.emplace_back();
      straight.kind = s.kind, straight.places = s.undeformed.empty() ? 0 : s.places;
      straight.placed_by = is_arrow(s) ? placement_kind::place : s.placed_by;
      straight.placements = s.undeformed;
    }
    return all;
  }

  Eigen::Matrix3Xd path_of(const animation::shape& s, Eigen::Vector3d placement::* which,
                           std::size_t place = 0) const {
    Eigen::Matrix3Xd path(3, times_);
    for (Eigen::Index k = 0; k < times_; ++k)
      path.col(k) = s.placement_at(static_cast<std::size_t>(k), place).*which;
    return path;
  }
  track pose_of(const animation::shape& s, std::size_t place) const {
    track pose{path_of(s, &placement::position, place), {}};
    for (std::size_t k = 0; k < from_.times.size(); ++k)
      pose.orientations.push_back(s.placement_at(k, place).orientation);
    return pose;
  }

  void read(const animation::shape& s) {
    for (std::size_t i = 0; i < s.places; ++i)
      if (s.placed_by == placement_kind::pose)
        add_pose(pose_of(s, i));
      else
        add_point(path_of(s, &placement::position, i));
    if (s.placed_by == placement_kind::ends && !is_arrow(s) && s.places != 0)
      add_point(path_of(s, &placement::end));
  }

  void add_pose(track pose) {
    if (!find_pose(pose)) bodies_.push_back(std::move(pose));
  }

  void add_point(Eigen::Matrix3Xd path) {
    if (!find_point(path)) points_.push_back(std::move(path));
  }

  std::optional<anchor> find_pose(const track& pose) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (const auto place = place_in(bodies_[i], pose.positions, tolerance_))
        if (keeps_orientation(bodies_[i], pose))
          return anchor{i, *place, bodies_[i].orientations[0].transpose() * pose.orientations[0]};
    return {};
  }

  /// Searches the bodies, then the single points, which are numbered after the bodies.
  std::optional<anchor> find_point(const Eigen::Matrix3Xd& path) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (const auto place = place_in(bodies_[i], path, tolerance_)) return anchor{i, *place};
    for (std::size_t i = 0; i < points_.size(); ++i)
      if ((points_[i] - path).lpNorm<Eigen::Infinity>() <= tolerance_) return anchor{bodies_.size() + i};
    return {};
  }

  bool are_rigid(std::size_t i, std::size_t k) const {
    return keep_distance(points_[i], points_[k], tolerance_);
  }

  /// Adds a body for each triangle of constant size, and removes the points that are fixed in a body.
  void find_triangles() {
    std::size_t first = 0;
    while (first < points_.size()) {
      if (std::optional<track> body = triangle_with(first)) {
        bodies_.push_back(std::move(*body));
        std::erase_if(points_, [&](const Eigen::Matrix3Xd& path) {
          return place_in(bodies_.back(), path, tolerance_).has_value();
        });
      } else {
        ++first;
      }
    }
  }

  /// The largest triangle is the most accurate one.
  std::optional<track> triangle_with(std::size_t origin) const {
    const auto at = [this](std::size_t i) -> Eigen::Vector3d { return points_[i].col(0); };
    const auto distance = [&](std::size_t i) { return (at(i) - at(origin)).norm(); };
    std::vector<std::size_t> rigid;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (i != origin && are_rigid(origin, i)) rigid.push_back(i);
    std::ranges::sort(rigid, [&](std::size_t i, std::size_t k) { return distance(i) > distance(k); });
    for (const std::size_t x : rigid) {
      const auto height = [&](std::size_t i) {
        return (at(x) - at(origin)).normalized().cross(at(i) - at(origin)).norm();
      };
      double highest = 1e-2 * distance(x);
      std::optional<std::size_t> third;
      for (const std::size_t i : rigid)
        if (height(i) > highest && are_rigid(x, i)) third = i, highest = height(i);
      if (third) return body_of(points_[origin], points_[x], points_[*third]);
    }
    return {};
  }

  std::vector<anchor> anchors_of(const animation::shape& s) {
    std::vector<anchor> anchors;
    anchors.reserve(s.places + 1);
    for (std::size_t i = 0; i < s.places; ++i)
      anchors.push_back(used(s.placed_by == placement_kind::pose
                                 ? *find_pose(pose_of(s, i))
                                 : *find_point(path_of(s, &placement::position, i))));
    if (s.placed_by != placement_kind::ends) return anchors;
    if (is_arrow(s)) {
      found_.all.push_back({path_of(s, &placement::end), {}});
      anchors.push_back({found_.all.size() - 1});
    } else {
      anchors.push_back(used(*find_point(path_of(s, &placement::end))));
    }
    return anchors;
  }

  /// Renumbers the track of an anchor, in the order of first use.
  anchor used(anchor a) {
    const std::size_t was = a.track;
    const auto known = std::ranges::find(used_, was, &std::pair<std::size_t, std::size_t>::first);
    if (known != used_.end()) {
      a.track = known->second;
      return a;
    }
    a.track = found_.all.size();
    used_.emplace_back(was, a.track);
    found_.all.push_back(was < bodies_.size() ? bodies_[was] : track{points_[was - bodies_.size()], {}});
    return a;
  }

  const animation& from_;
  Eigen::Index times_;
  double tolerance_ = 0;
  std::vector<track> bodies_{};
  std::vector<Eigen::Matrix3Xd> points_{};
  tracks found_{};
  std::vector<std::pair<std::size_t, std::size_t>> used_{};
};

} // namespace detail

inline tracks tracks_of(const animation& a) { return detail::track_finder(a).find(); }

} // namespace kanexpr::animate
