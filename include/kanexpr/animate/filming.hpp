#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/placed.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <Eigen/Core>
#include <charconv>
#include <span>
#include <string>

/// Converts the numbers of a picture at each time to its shapes.
namespace kanexpr::animate {

/// The numbers of a picture and the integrals of its rates, one column for each time.
struct footage {
  Eigen::MatrixXd numbers{}, integrals{};
};

inline Eigen::Vector3d triple(const Eigen::MatrixXd& m, int row, Eigen::Index column) {
  return m.block<3, 1>(row, column);
}

inline animation::shape shape_of(const word_record& r, const footage& f) {
  animation::shape s;
  s.name = r.looks.name.empty() ? r.name.view() : r.looks.name;
  s.kind = r.shape;
  s.colour = r.looks.colour;
  s.file = r.file;
  s.opacity = r.looks.opacity;
  s.placed_by = r.placed_by;
  for (int i = 0; i < r.still; ++i) s.sizes.push_back(f.numbers(r.first_still + i, 0));
  for (Eigen::Index k = 0; k < f.numbers.cols(); ++k) {
    placement here = placed(r, f.numbers.col(k).data() + r.first_moving);
    if (r.rates == 1)
      here.orientation *= Eigen::AngleAxisd(f.integrals(r.first_rate, k), Eigen::Vector3d::UnitZ()).matrix();
    s.placements.push_back(here);
  }
  return s;
}

/// Moves all shapes with the origin, whose path follows from the velocity of a point; see `carried`.
inline void carry(animation& a, const word_record& r, const footage& f) {
  a.carried = true;
  for (Eigen::Index k = 0; k < f.numbers.cols(); ++k) {
    const Eigen::Vector3d way = triple(f.integrals, r.first_rate, k) - triple(f.numbers, r.first_moving, k) +
                                triple(f.numbers, r.first_moving, 0);
    const Eigen::Vector3d level = way - way.dot(a.up) * a.up;
    for (animation::shape& s : a.shapes) {
      s.placements[static_cast<std::size_t>(k)].position += level;
      s.placements[static_cast<std::size_t>(k)].end += level;
    }
  }
}

inline void develop(animation& a, std::span<const word_record> words, const footage& f) {
  for (const word_record& r : words) {
    if (!r.shape.empty()) a.shapes.push_back(shape_of(r, f));
    if (r.word == "up") a.up = triple(f.numbers, r.first_still, 0).normalized();
    if (r.word == "seen_from") a.seen_from = triple(f.numbers, r.first_still, 0).normalized();
    if (r.word == "files_in") a.folder = r.file;
    if (r.word == "ground") a.ground = f.numbers(r.first_still, 0);
  }
  for (const word_record& r : words)
    if (r.word == "carried") carry(a, r, f);
}

inline std::string at_time(double t) {
  char digits[32];
  return " at t = " + std::string(digits, std::to_chars(digits, digits + sizeof digits, t).ptr);
}

/// Checks a size or a scale. A scale may be negative, which mirrors the mesh.
inline std::string check_number(const animation::shape& s, double size) {
  const bool is_scale = s.kind == "mesh";
  if (numeric::is_finite(size) && (size > 0 || (is_scale && size < 0))) return {};
  if (is_scale) return "a scale of the " + s.name + " must be finite and nonzero";
  return "a size of the " + s.name + " must be positive and finite";
}

/// Returns a sentence that names the first value in an animation that is not finite or out of range; empty if
/// there is none.
inline std::string check_numbers(const animation& a) {
  if (!numeric::all_finite(a.up) || !(a.up.norm() > 0.5))
    return "the direction of up must be a nonzero vector";
  if (a.seen_from && (!numeric::all_finite(*a.seen_from) || !(a.seen_from->norm() > 0.5)))
    return "the direction of seen_from must be a nonzero vector";
  if (a.ground && !numeric::is_finite(*a.ground)) return "the height of the ground must be finite";
  for (const animation::shape& s : a.shapes) {
    for (double size : s.sizes)
      if (std::string cause = check_number(s, size); !cause.empty()) return cause;
    for (std::size_t k = 0; k < s.placements.size(); ++k) {
      const placement& here = s.placements[k];
      if (!numeric::all_finite(here.position) || !numeric::all_finite(here.end))
        return "the position of the " + s.name + " is not finite" + at_time(a.times[k]);
      if (!numeric::all_finite(here.orientation))
        return "the orientation of the " + s.name + " is not finite" + at_time(a.times[k]);
    }
  }
  return {};
}

} // namespace kanexpr::animate
