#pragma once

#include <kanexpr/animate/about_axis.hpp>
#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/homogeneous_solid.hpp>
#include <kanexpr/animate/load_shapes.hpp>
#include <kanexpr/animate/placed_shapes.hpp>
#include <kanexpr/animate/recorded_outlines.hpp>
#include <kanexpr/animate/recorded_poses.hpp>
#include <kanexpr/animate/rigid_parts.hpp>
#include <kanexpr/figures/geometry.hpp>
#include <kanexpr/figures/outlines.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::animate {

/// Chooses the shapes of a model: links between the places of each rigid part, solids for bodies that have no
/// other extent, strips for beams, pins and balls at joints, rails along which points slide, and spheres for
/// particles; `load_shapes` adds those of the loads. All sizes are fractions of the longest link.
class default_shapes {
public:
  default_shapes(const mechanics::multibody_system& system, const rigid_parts& parts,
                 const recorded_poses& poses, const recorded_outlines& flexible,
                 const figures::geometry& first)
      : system_(system), m_(system.mechanism), parts_(parts), poses_(poses), flexible_(flexible),
        deflections_(system.mechanism), first_(first), length_(unit()), made_(poses) {}

  /// Adds the shapes, and sets the ground of a model with weight.
  void add_to(animation& a, bool has_ground);
  /// A link from the ground to the center of a rolling wheel; null if there is none.
  const straight_piece* rolling_link() const {
    const auto found = std::ranges::find_if(
        parts_.links(), [&](const straight_piece& l) { return wheel_around(l) != mechanics::none; });
    return found == parts_.links().end() ? nullptr : &*found;
  }

private:
  std::string color_of_body(int body) const {
    constexpr std::array<std::string_view, 8> palette{"#4a7fb5", "#d0694a", "#6f9e54", "#dfa63c",
                                                      "#8568ae", "#3a9d93", "#99705a", "#687488"};
    return std::string(palette[static_cast<std::size_t>(body) % palette.size()]);
  }
  std::string color_of_part(int part) const {
    const int body = part == 0 ? mechanics::none : parts_.body_of(part);
    return body == mechanics::none ? std::string(placed_shapes::grey) : color_of_body(body);
  }
  std::string name_of_point(int point) const { return std::string(m_.points[point].called.view()); }
  std::string name_of_body(int body) const { return std::string(m_.bodies[body].called.view()); }

  double distance(const straight_piece& l) const {
    return (poses_.place(l.to, 0) - poses_.place(l.from, 0)).norm();
  }
  homogeneous_solid solid_of_body(int body) const {
    return solid_of(first_.masses[static_cast<std::size_t>(body)],
                    first_.inertias[static_cast<std::size_t>(body)]);
  }
  /// The same for a body on a link; if its inertia is given about one axis only, as in a planar model, it is
  /// a rod along the link.
  homogeneous_solid solid_on_link(int body) const;
  double unit() const;
  /// The largest distance of a node from the first one at the first sample.
  static double extent_of(const recorded_nodes& body) {
    double largest = 0;
    for (std::size_t i = 1; i < body.nodes; ++i)
      largest = (std::max)(largest, (body.places[i] - body.places[0]).norm());
    return largest;
  }
  /// The length of a beam at the first sample.
  double length_of(const recorded_beam& beam) const {
    double sum = 0;
    for (std::size_t i = 1; i < beam.sections; ++i)
      sum += (beam.placements[i].position - beam.placements[i - 1].position).norm();
    return sum;
  }
  /// The body whose solid contains a link without mass, from the rim to the mass center: a rolling wheel.
  int wheel_around(const straight_piece& l) const;
  bool coincide(int place, int other) const {
    return (poses_.place(place, 0) - poses_.place(other, 0)).norm() < 1e-9 * length_;
  }
  struct links_of_part {
    bool end_at_place = false;
    int count = 0;
    double longest = 0;
  };
  links_of_part links_at(int part, int place) const;
  double radius_of(const straight_piece& l) const;

  void add_link(const straight_piece& l);
  void add_body(int body);
  void add_beam(const recorded_beam& beam);
  void add_nodes(const recorded_nodes& body);
  void add_joint(int part);
  void add_slide(const straight_piece& l);
  /// Whether a frame belongs to a body without mass, such as the rotor of a motor, which has no place.
  bool turns_rotor(int frame) const {
    bool found = false;
    for (const mechanics::body& b : m_.bodies) found = found || (b.frame == frame && b.mass.is_zero());
    return found;
  }
  void add_ground(animation& a) const;
  double lowest(const Eigen::Vector3d& up) const;

  const mechanics::multibody_system& system_;
  const mechanics::mechanism& m_;
  const rigid_parts& parts_;
  const recorded_poses& poses_;
  const recorded_outlines& flexible_;
  figures::deflections deflections_;
  const figures::geometry& first_; ///< the geometry at the first sample
  double length_;
  placed_shapes made_;
};

inline homogeneous_solid default_shapes::solid_on_link(int body) const {
  const mechanics::body& b = m_.bodies[body];
  const Eigen::Matrix3d& inertia = first_.inertias[static_cast<std::size_t>(body)];
  const double moment = inertia.trace();
  const bool is_about_one_axis = (inertia * inertia - moment * inertia).norm() <= 1e-9 * moment * moment;
  for (const straight_piece& l : parts_.links()) {
    if (!is_about_one_axis || l.part != parts_.part_of(b.frame)) continue;
    const Eigen::Vector3d along = (poses_.place(l.to, 0) - poses_.place(l.from, 0)).stableNormalized();
    return solid_of(first_.masses[static_cast<std::size_t>(body)],
                    moment * (Eigen::Matrix3d::Identity() - along * along.transpose()));
  }
  return solid_of_body(body);
}

/// The longest beam or link of a moving part; else the largest body, the longest link, or the extent of the
/// points.
inline double default_shapes::unit() const {
  double moving = 0, fixed = 0, solid = 0;
  for (const straight_piece& l : parts_.links()) {
    double& longest = l.part == 0 ? fixed : moving;
    longest = (std::max)(longest, distance(l));
  }
  for (const recorded_beam& beam : flexible_.beams) moving = (std::max)(moving, length_of(beam));
  for (const recorded_nodes& body : flexible_.nodes) moving = (std::max)(moving, extent_of(body));
  for (int i = 0; i < m_.bodies.size(); ++i) solid = (std::max)(solid, solid_of_body(i).extent() / 2);
  for (const double each : {moving, solid, fixed})
    if (each > 0) return each;
  return first_.size / 2;
}

inline default_shapes::links_of_part default_shapes::links_at(int part, int place) const {
  links_of_part found;
  for (const straight_piece& l : parts_.links()) {
    if (l.part != part || distance(l) < 1e-9 * length_) continue;
    ++found.count;
    found.longest = (std::max)(found.longest, distance(l));
    found.end_at_place = found.end_at_place || coincide(l.from, place) || coincide(l.to, place);
  }
  return found;
}

inline double default_shapes::radius_of(const straight_piece& l) const {
  const bool has_body = l.part != 0 && parts_.body_of(l.part) != mechanics::none;
  return (has_body ? 1.0 : 0.5) * std::clamp(0.2 * distance(l), 0.01 * length_, 0.045 * length_);
}

inline int default_shapes::wheel_around(const straight_piece& l) const {
  if (l.part == 0 || parts_.body_of(l.part) != mechanics::none) return mechanics::none;
  for (int i = 0; i < m_.bodies.size(); ++i) {
    const mechanics::body& b = m_.bodies[i];
    if (b.frame == mechanics::none || !coincide(l.to, b.center) || parts_.has_links(parts_.part_of(b.frame)))
      continue;
    const homogeneous_solid solid = solid_of_body(i);
    if (solid.kind == "cylinder" && distance(l) < 1.05 * solid.sizes[0] && distance(l) > 0.5 * solid.sizes[0])
      return i;
  }
  return mechanics::none;
}

inline void default_shapes::add_link(const straight_piece& l) {
  if (distance(l) < 1e-9 * length_ || wheel_around(l) != mechanics::none) return;
  const int body = l.part == 0 ? mechanics::none : parts_.body_of(l.part);
  const std::string name =
      body == mechanics::none ? std::string(m_.frames[l.part].called.view()) : name_of_body(body);
  made_.add_between("link of " + name, "rod", color_of_part(l.part), {radius_of(l)}, l.from, l.to);
}

/// A particle is a sphere. A rigid body is its links with a sphere at the mass center; if it has at most one
/// link, also the homogeneous solid with its inertia.
inline void default_shapes::add_body(int body) {
  const mechanics::body& b = m_.bodies[body];
  const std::string name = name_of_body(body), colour = color_of_body(body);
  if (b.frame == mechanics::none) return made_.add_sphere(name, colour, 0.09 * length_, b.center);
  const auto [is_linked, links, longest] = links_at(parts_.part_of(b.frame), b.center);
  homogeneous_solid solid = is_linked ? solid_on_link(body) : solid_of_body(body);
  if (is_linked && links > 1) solid = {};
  if (is_linked) made_.add_sphere("mass center of " + name, colour, 0.06 * length_, b.center);
  if (!solid.exists()) {
    if (!is_linked) made_.add_sphere(name, colour, 0.09 * length_, b.center);
    return;
  }
  for (const straight_piece& l : parts_.links())
    if (wheel_around(l) == body) solid.sizes[0] = distance(l);
  const double most = (std::max)(2.2 * longest, 0.5 * length_),
               excess = is_linked ? solid.extent() / most : 1;
  for (double& size : solid.sizes) {
    if (excess > 1) size /= excess;
    size = (std::max)(size, 0.045 * length_);
  }
  const Eigen::Matrix3d in_frame = poses_.frame(b.frame, 0).transpose() * solid.axes;
  made_.add_solid(name, solid.kind, colour, solid.sizes, b.center, b.frame, in_frame);
}

/// A beam is a strip that is thin in its first direction of bending.
inline void default_shapes::add_beam(const recorded_beam& beam) {
  const double width = 0.08 * length_of(beam);
  animation::shape s{.name = std::string(m_.flexible_bodies[beam.body].called.view()),
                     .kind = "beam",
                     .colour = color_of_body(m_.bodies.size() + beam.body),
                     .profile = "rectangle",
                     .sizes = {width, width / 3},
                     .placed_by = placement_kind::pose,
                     .places = beam.sections};
  s.placements = beam.placements;
  made_.add(std::move(s));
}

/// A flexible body that is given by numbers is shown as its nodes, connected by thin rods.
inline void default_shapes::add_nodes(const recorded_nodes& body) {
  const mechanics::flexible_body& f = m_.flexible_bodies[body.body];
  const std::string name(f.called.view()), colour = color_of_body(m_.bodies.size() + body.body);
  const auto place = [&](std::size_t k, std::size_t i) { return body.places[k * body.nodes + i]; };
  for (std::size_t i = 0; i < body.nodes; ++i)
    made_.add({.name = "node " + std::string(f.nodes.all[static_cast<int>(i)].called.view()) + " of " + name,
               .kind = "sphere",
               .colour = colour,
               .sizes = {0.025 * length_}},
              [&](std::size_t k) { return placement{.position = place(k, i)}; });
  const std::vector<Eigen::Vector3d> first(body.places.begin(),
                                           body.places.begin() + static_cast<std::ptrdiff_t>(body.nodes));
  for (const auto& ends : figures::shortest_connections(first))
    made_.add({.name = name,
               .kind = "rod",
               .colour = colour,
               .sizes = {0.012 * length_},
               .placed_by = placement_kind::ends},
              [&](std::size_t k) {
                return placement{.position = place(k, ends.first), .end = place(k, ends.second)};
              });
}

/// A rotation by an angle is a pin along its axis, so two successive ones are the cross of a universal joint.
/// Three successive rotations or another orientation are a ball.
inline void default_shapes::add_joint(int part) {
  const auto carrier = [&](int p) { return parts_.part_of(m_.frames[p].parent); };
  const auto is_between = [&](int p) {
    return p != 0 && !parts_.has_links(p) && parts_.body_of(p) == mechanics::none &&
           !deflections_.turn(m_.frames[p]);
  };
  if (deflections_.turn(m_.frames[part])) return;
  std::vector<int> turns{part};
  while (is_between(carrier(turns.back()))) turns.push_back(carrier(turns.back()));
  const int at = parts_.joint_of(part);
  if (at == mechanics::none || is_between(part) || !parts_.is_supported(at)) return;
  for (const straight_piece& l : parts_.links())
    if (l.part == part && wheel_around(l) != mechanics::none) return; // it rolls
  const bool is_ball = turns.size() > 2 || !m_.frames[part].is_by_angle();
  if (is_ball && parts_.has_links(part))
    return made_.add_sphere("ball joint at " + name_of_point(at), std::string(placed_shapes::dark),
                            0.08 * length_, at);
  if (is_ball) return;
  for (const int f : turns) {
    const Eigen::Vector3d axis = first_.rotation_axes[static_cast<std::size_t>(f)];
    if (!(axis.norm() > 0)) continue;
    const Eigen::Matrix3d now = poses_.frame(f, 0);
    const Eigen::Matrix3d about = about_axis(axis, now.col(0), now.col(1));
    made_.add_solid("pin at " + name_of_point(at), "cylinder", std::string(placed_shapes::dark),
                    {0.065 * length_, 0.18 * length_}, at, f, now.transpose() * about);
  }
}

/// A rail that covers the motion, and a slider on it.
inline void default_shapes::add_slide(const straight_piece& l) {
  Eigen::Vector3d along = Eigen::Vector3d::Zero(); // in the part
  double least = 0, most = 0;
  const auto offset = [&](std::size_t k) -> Eigen::Vector3d {
    return poses_.frame(l.part, k).transpose() * (poses_.place(l.to, k) - poses_.place(l.from, k));
  };
  for (std::size_t k = 0; k < poses_.samples(); ++k)
    if (offset(k).norm() > along.norm()) along = offset(k);
  if (!(along.norm() > 0)) return;
  along.normalize();
  for (std::size_t k = 0; k < poses_.samples(); ++k)
    least = (std::min)(least, along.dot(offset(k))), most = (std::max)(most, along.dot(offset(k)));
  const std::string name = l.to < m_.points.size() ? name_of_point(l.to) : "a corner";
  const double over = 0.15 * length_;
  made_.add({.name = "rail of " + name,
             .kind = "rod",
             .colour = std::string(placed_shapes::grey),
             .sizes = {0.014 * length_},
             .placed_by = placement_kind::ends},
            [&](std::size_t k) {
              const Eigen::Vector3d from = poses_.place(l.from, k), axis = poses_.frame(l.part, k) * along;
              return placement{.position = from + (least - over) * axis, .end = from + (most + over) * axis};
            });
  const Eigen::Matrix3d axes = about_axis(along, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  made_.add_solid("slider at " + name, "box", std::string(placed_shapes::dark),
                  {0.1 * length_, 0.1 * length_, 0.17 * length_}, l.to, l.part, axes);
}

/// The least height of the shapes along the motion.
inline double default_shapes::lowest(const Eigen::Vector3d& up) const {
  double least = 0;
  for (const animation::shape& s : made_.all())
    for (const placement& p : s.placements) {
      const Eigen::Vector3d turned = p.orientation.transpose() * up;
      double reach = s.sizes.front();
      if (s.kind == "box")
        reach = 0.5 * Eigen::Vector3d(s.sizes.data()).dot(turned.cwiseAbs());
      else if (s.kind == "cylinder")
        reach = s.sizes[0] * turned.head<2>().norm() + 0.5 * s.sizes[1] * std::abs(turned(2));
      else if (s.kind == "cone")
        reach = (std::max)(0.0, s.sizes[0] * turned.head<2>().norm() - s.sizes[1] * turned(2));
      least = (std::min)(least, up.dot(p.position) - reach);
      if (s.placed_by == placement_kind::ends) least = (std::min)(least, up.dot(p.end) - reach);
    }
  return least;
}

/// The ground is below rolling wheels, touches a model that stands on the level of its origin, and is below a
/// model that hangs.
inline void default_shapes::add_ground(animation& a) const {
  if (const straight_piece* const rolling = rolling_link()) {
    a.ground = a.up.dot(poses_.place(rolling->from, 0));
    return;
  }
  const double least = lowest(a.up);
  a.ground = least > -0.25 * length_ ? least : least - 0.2 * length_;
}

inline void default_shapes::add_to(animation& a, bool has_ground) {
  for (const straight_piece& l : parts_.slides()) add_slide(l);
  for (const straight_piece& l : parts_.links()) add_link(l);
  for (int f = 1; f < m_.frames.size(); ++f)
    if (parts_.part_of(f) == f && !turns_rotor(f)) add_joint(f);
  for (int i = 0; i < m_.bodies.size(); ++i)
    if (!m_.bodies[i].mass.is_zero()) add_body(i);
  for (const recorded_beam& beam : flexible_.beams) add_beam(beam);
  for (const recorded_nodes& body : flexible_.nodes) add_nodes(body);
  load_shapes loads(system_, poses_, first_, length_, made_);
  loads.add_springs();
  loads.add_pathways();
  if (has_ground) add_ground(a);
  a.shapes = made_.take();
}

} // namespace kanexpr::animate
