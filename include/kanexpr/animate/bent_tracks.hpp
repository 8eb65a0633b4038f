#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/tracks.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

/// The tracks of shapes that bend. The stations of a beam with two modes move relative to its root by a
/// combination of a few deflections, which are the same at all times. A page stores these deflections once,
/// and only their weights at each time. They are the principal components of the placements, whatever their
/// source.
namespace kanexpr::animate {

/// The motion of several bodies relative to another one, as a mean and a weighted sum of deflections. Each
/// body has 6 numbers: its position divided by `size`, and its rotation vector, both in the axes of the base.
struct bending {
  std::size_t base = 0;              ///< the track relative to which the others move
  std::vector<std::size_t> tracks{}; ///< the other tracks
  double size = 1;                   ///< the largest distance from the base
  Eigen::VectorXd mean{};            ///< the numbers of all tracks, averaged over time
  Eigen::MatrixXd deflections{};     ///< one column for each deflection
  Eigen::MatrixXd weights{};         ///< one row for each deflection, one column for each time
};

namespace detail {

/// Errors of a bent shape that are not visible, relative to its size and in radians.
inline constexpr double invisible = 1e-5;

inline Eigen::Vector<double, 6> relative_numbers(const track& base, const track& other, Eigen::Index time,
                                                 double size) {
  const auto k = static_cast<std::size_t>(time);
  const Eigen::Matrix3d back = base.orientations[k].transpose();
  const Eigen::AngleAxisd turned(Eigen::Matrix3d(back * other.orientations[k]));
  Eigen::Vector<double, 6> numbers;
  numbers << back * (other.positions.col(time) - base.positions.col(time)) / size,
      turned.angle() * turned.axis();
  return numbers;
}

inline double largest_distance(const bending& b, const std::vector<track>& all) {
  double largest = 0;
  for (const std::size_t i : b.tracks)
    largest = (std::max)(largest, (all[i].positions - all[b.base].positions).colwise().norm().maxCoeff());
  return largest;
}

inline Eigen::MatrixXd numbers_of(const bending& b, const std::vector<track>& all) {
  const Eigen::Index times = all[b.base].positions.cols();
  Eigen::MatrixXd numbers(6 * static_cast<Eigen::Index>(b.tracks.size()), times);
  for (Eigen::Index k = 0; k < times; ++k)
    for (std::size_t i = 0; i < b.tracks.size(); ++i)
      numbers.block<6, 1>(6 * static_cast<Eigen::Index>(i), k) =
          relative_numbers(all[b.base], all[b.tracks[i]], k, b.size);
  return numbers;
}

/// The unit vector along which the columns are largest in the mean square, by power iteration from the
/// largest one. Where other directions are almost as large, it may be a mixture, which is as good. Compilers
/// take seconds for a solver of eigenvalues of any order.
inline Eigen::VectorXd principal_direction(const Eigen::MatrixXd& columns) {
  constexpr int iterations = 8;
  Eigen::Index largest = 0;
  columns.colwise().squaredNorm().maxCoeff(&largest);
  Eigen::VectorXd direction = columns.col(largest).normalized();
  for (int i = 0; i < iterations; ++i) {
    const Eigen::RowVectorXd along = direction.transpose().lazyProduct(columns);
    direction = columns.lazyProduct(along.transpose());
    direction.normalize();
  }
  return direction;
}

/// Finds the deflections; returns false if there are so many that they would save little.
inline bool find_deflections(bending& b, const Eigen::MatrixXd& numbers) {
  b.mean = numbers.rowwise().mean();
  Eigen::MatrixXd rest = numbers.colwise() - b.mean;
  const Eigen::Index most = (std::min)(numbers.rows() / 2, numbers.cols() / 2);
  b.deflections.resize(numbers.rows(), 0);
  b.weights.resize(0, numbers.cols());
  for (Eigen::Index count = 0; rest.lpNorm<Eigen::Infinity>() > invisible; ++count) {
    if (count == most) return false;
    b.deflections.conservativeResize(Eigen::NoChange, count + 1);
    b.weights.conservativeResize(count + 1, Eigen::NoChange);
    b.deflections.col(count) = principal_direction(rest);
    b.weights.row(count) = b.deflections.col(count).transpose().lazyProduct(rest);
    rest -= b.deflections.col(count).lazyProduct(b.weights.row(count));
  }
  return true;
}

/// The part of each track in bendings: none, a base, or one that bends.
enum class part_in_bending : unsigned char { none, base, bent };

/// The bending of the stations of a shape relative to the first one, without its deflections.
inline bending bending_of(const std::vector<anchor>& anchors, const std::vector<part_in_bending>& parts) {
  bending b;
  b.base = anchors.front().track;
  for (const anchor& a : anchors)
    if (a.track != b.base && parts[a.track] == part_in_bending::none &&
        std::ranges::find(b.tracks, a.track) == b.tracks.end())
      b.tracks.push_back(a.track);
  return b;
}

} // namespace detail

/// Returns the bendings of all shapes with several stations. A track takes part in one bending at most.
inline std::vector<bending> bendings_of(const animation& a, const tracks& of) {
  using detail::part_in_bending;
  std::vector<bending> found;
  std::vector<part_in_bending> parts(of.all.size(), part_in_bending::none);
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    if (a.shapes[i].places < 3 || a.shapes[i].placed_by != placement_kind::pose) continue;
    bending b = detail::bending_of(of.of_shape[i], parts);
    b.size = detail::largest_distance(b, of.all);
    if (b.tracks.size() < 2 || !(b.size > 0) || parts[b.base] == part_in_bending::bent ||
        !detail::find_deflections(b, detail::numbers_of(b, of.all)))
      continue;
    parts[b.base] = part_in_bending::base;
    for (const std::size_t k : b.tracks) parts[k] = part_in_bending::bent;
    found.push_back(b);
  }
  return found;
}

} // namespace kanexpr::animate
