#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/robots/physical_quantity.hpp>
#include <kanexpr/robots/plan.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::robots {

/// A robot as a run-time model: a builder with the joints, links and motors of the robot, to which loads and
/// constraints may be added. `derive(arm)` and `simulate(arm, …)` accept it like any other builder.
///
/// The coordinates are px, py, pz, e1, e2, e3, e0 of a floating base, followed by q_JOINT for each joint in
/// the order of the file; the speeds are vx, vy, vz, wx, wy, wz of the base, followed by u_JOINT for each
/// joint. The inputs are T_JOINT (torques) and F_JOINT (forces).
class robot_builder : public runtime::builder {
public:
  using frame_id = runtime::frame_id;
  using point_id = runtime::point_id;

  explicit robot_builder(robot r, const model_options& options = {});

  /// The first mistake as a sentence; empty if there is none.
  std::string cause() const { return plan_.mistake.empty() ? std::string((check)().view()) : plan_.mistake; }

  /// Return the axes and the origin of the link with the given name in the file; those of the ground if there
  /// is no such link.
  frame_id frame_of(std::string_view link) const { return frames_[index_of(link)]; }
  point_id origin_of(std::string_view link) const { return origins_[index_of(link)]; }

  /// Returns the name of the body that contains the mass of a link and of all links fixed to it. The body is
  /// named after the moving link: "Forearm_body" for a tool on a forearm. The name is empty if the link is
  /// part of the ground or the body has no mass.
  std::string body_of(std::string_view link) const {
    const std::size_t place = index_of(link);
    if (place >= plan_.tree.links.size()) return {};
    const moving_body& b = entry(plan_.tree.bodies, plan_.tree.links[place].body);
    return plan_.is_on_ground(b) || !b.has_mass() ? "" : plan_.name(b.link) + "_body";
  }

  /// The parameters with their values in the file, in order.
  const std::vector<std::pair<std::string, double>>& values() const { return values_; }

  /// Returns the values, by name, of the state at rest in which all joint positions are zero.
  std::map<std::string, double> at_rest() const {
    std::map<std::string, double> x;
    for (const planned_joint& j : plan_.joints) {
      for (const planned_symbol& q : j.coordinates) x[q.called] = 0;
      for (const planned_symbol& u : j.speeds) x[u.called] = 0;
      if (j.kind == joint_kind::floating) x[j.coordinates.back().called] = 1;
    }
    return x;
  }

  const robots::plan& plan() const { return plan_; }

private:
  using expression = symbolic::expression;
  using vector = mechanics::vector;
  using kind = physical_quantity;

  /// The coordinates and speeds of a joint, or the expressions that determine them, and its input.
  struct motion {
    std::vector<expression> q{}, u{};
    expression drive{};
  };

  struct weight {
    expression mass{};
    point_id center{};
  };

  std::size_t index_of(std::string_view link) const {
    const auto found = index_by_name_.find(link);
    return found == index_by_name_.end() ? frames_.size() - 1 : found->second;
  }
  frame_id& frame(int link) { return entry(frames_, link); }
  point_id& origin(int link) { return entry(origins_, link); }

  vector along_numbers(frame_id axes, const vector3& v) { return along(axes, v[0], v[1], v[2]); }

  expression with_unit(expression e, kind q) {
    imply_unit(e, robots::unit_of(q));
    return e;
  }
  /// Returns a number from the file, or a parameter with that value.
  expression value(const std::string& called, double in_file, kind q) {
    if (plan_.binds_numbers()) return number(in_file);
    values_.emplace_back(called, in_file);
    return with_unit(parameter(called), q);
  }
  /// Adds a frame rotated relative to `in`; returns `in` itself if there is no rotation.
  frame_id rotated_frame(const std::string& called, frame_id in, const rotation& by) {
    if (by == no_rotation) return in;
    mechanics::matrix3 to_parent;
    for (int i = 0; i < 3; ++i) {
      const vector3& row = entry(by, i);
      to_parent.row[i] = {number(row[0]), number(row[1]), number(row[2])};
    }
    return direction_cosines(called, in, to_parent);
  }
  point_id offset_point(const std::string& called, point_id from, frame_id axes, const vector3& by) {
    return is_zero(by) ? from : offset(called, from, along_numbers(axes, by));
  }

  vector symbols_along(const std::string& called, frame_id axes, const vector3& v) {
    const expression x = value("x_" + called, v[0], kind::length),
                     y = value("y_" + called, v[1], kind::length),
                     z = value("z_" + called, v[2], kind::length);
    return along(axes, x, y, z);
  }

  void add_symbols() {
    for (const planned_joint& j : plan_.joints) {
      motion& m = motions_.emplace_back();
      for (const planned_symbol& q : j.coordinates) m.q.push_back(with_unit(coordinate(q.called), q.is));
    }
    for (std::size_t i = 0; i < motions_.size(); ++i)
      for (const planned_symbol& u : plan_.joints[i].speeds)
        motions_[i].u.push_back(with_unit(speed(u.called), u.is));
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const planned_symbol& drive = plan_.joints[i].input;
      motions_[i].drive =
          drive.called.empty() ? mechanism().zero() : with_unit(input(drive.called), drive.is);
    }
  }

  /// Returns the motion of a joint; the motion of a mimic joint is expressed in the symbols of its leader.
  motion motion_of(int joint) {
    const mimic_rule rule = resolved_mimic(robot_, joint);
    const motion& leader = entry(motions_, entry(plan_.joint_of, rule.leader));
    if (rule.leader == joint) return leader;
    const motion made{
        {rule.multiplier * leader.q[0] + rule.offset}, {rule.multiplier * leader.u[0]}, mechanism().zero()};
    if (!base::equal(rule.multiplier, 1.0) && plan_.multiplier_of(joint) != kind::ratio)
      imply_units(made, joint);
    return made;
  }
  /// Gives the units of the motion of a joint that turns as another slides, or slides as it turns.
  void imply_units(const motion& m, int joint) {
    const bool slides = entry(robot_.joints, joint).kind == joint_kind::prismatic;
    with_unit(m.q[0], slides ? kind::length : kind::angle);
    with_unit(m.u[0], slides ? kind::velocity : kind::angular_velocity);
  }

  void add_root() {
    const moving_body& root = plan_.tree.bodies[0];
    const point_id ground = builder::origin("O");
    frame(root.link) = inertial_frame(), origin(root.link) = ground;
    frames_.back() = inertial_frame(), origins_.back() = ground;
    if (plan_.has_floating_base()) add_floating_joint(root.link, inertial_frame(), ground, motions_[0]);
  }

  void add_joint(const moving_body& b) {
    const moving_body& in = plan_.parent_of(b);
    const motion m = motion_of(b.joint);
    const joint& j = plan_.joint_of_body(b);
    const std::string& called = plan_.name(b.link);
    if (j.kind == joint_kind::prismatic) {
      const frame_id axes = rotated_frame(called, frame(in.link), b.origin.orientation);
      const point_id start =
          offset_point(called + "_start", origin(in.link), frame(in.link), b.origin.position);
      const vector axis = along_numbers(axes, j.axis);
      frame(b.link) = axes;
      origin(b.link) = offset(called + "_origin", start, m.q[0] * axis);
      force_between(origin(b.link), start, drive_of(b, m) * axis);
      return;
    }
    const frame_id home = rotated_frame(called + "_home", frame(in.link), b.origin.orientation);
    if (j.kind == joint_kind::revolute || j.kind == joint_kind::continuous) {
      const vector axis = along_numbers(home, j.axis);
      frame(b.link) = rotated(called, home, m.q[0], axis);
      origin(b.link) = offset_point(called + "_origin", origin(in.link), frame(in.link), b.origin.position);
      torque_between(frame(b.link), frame(in.link), drive_of(b, m) * axis);
      return;
    }
    const point_id start =
        offset_point(called + "_start", origin(in.link), frame(in.link), b.origin.position);
    if (j.kind == joint_kind::floating) return add_floating_joint(b.link, home, start, m);
    const auto [first, second] = normal_directions(j.axis);
    frame(b.link) = rotated(called, home, m.q[2], along_numbers(home, j.axis));
    vector gone = m.q[0] * along_numbers(home, first);
    gone.add(m.q[1] * along_numbers(home, second));
    origin(b.link) = offset(called + "_origin", start, gone);
  }

  /// Adds the dry friction of a joint with one coordinate.
  void add_friction(const moving_body& b) {
    const joint& j = plan_.joint_of_body(b);
    if (!plan_.has_friction(j)) return;
    const dry_friction& by = *plan_.options.friction;
    const bool slides = j.kind == joint_kind::prismatic;
    const expression f = value("f_" + plan_.name(b.link), j.friction, slides ? kind::force : kind::torque);
    friction_along(given_length(motion_of(b.joint).q[0]), number(1.0),
                   mechanics::friction_law::coulomb(f, number(slides ? by.sliding : by.turning)));
  }

  /// Adds stops at the limits of a joint with one coordinate.
  void add_stops(const moving_body& b) {
    const joint& j = plan_.joint_of_body(b);
    if (!plan_.has_stops(j)) return;
    const limit_stops& by = *plan_.options.stops;
    const double stiffness = j.kind == joint_kind::prismatic ? by.sliding : by.turning;
    stop(given_length(motion_of(b.joint).q[0]), number((std::max)(j.limits.lower, -by.no_limit)),
         number((std::min)(j.limits.upper, by.no_limit)), number(stiffness), number(by.damping),
         number(by.width));
  }

  /// Lets a link move freely. The position is expressed in the parent's axes, the velocity and the angular
  /// velocity in the axes of the link.
  void add_floating_joint(int link, frame_id in, point_id start, const motion& m) {
    const std::string& called = plan_.name(link);
    const frame_id own = quaternion(called, in, m.q[6], m.q[3], m.q[4], m.q[5]);
    angular_velocity(own, in, along(own, m.u[3], m.u[4], m.u[5]));
    const point_id at = offset(called + "_origin", start, along(in, m.q[0], m.q[1], m.q[2]));
    const vector v = along(own, m.u[0], m.u[1], m.u[2]);
    velocity_from_parent(at, in, v);
    for (std::size_t i = 0; i < 3; ++i) {
      vector3 basis{};
      basis[i] = 1;
      kinematic_equation(dot(m.q[i]) - builder::dot(v, along_numbers(in, basis)));
    }
    kinematics_of(own, in);
    frame(link) = own, origin(link) = at;
  }

  /// The torque or force along the axis of a joint.
  expression drive_of(const moving_body& b, const motion& m) {
    const joint& j = plan_.joint_of_body(b);
    const bool slides = j.kind == joint_kind::prismatic;
    expression drive = m.drive;
    if (plan_.options.damping && j.damping > 0)
      drive = drive -
              value("c_" + plan_.name(b.link), j.damping, slides ? kind::damping : kind::angular_damping) *
                  m.u[0];
    return drive;
  }

  void add_mass(const moving_body& b) {
    if (plan_.is_on_ground(b) || !b.has_mass()) return;
    const std::string& called = plan_.name(b.link);
    const frame_id axes = frame(b.link);
    const inertia_matrix& i = b.inertia;
    const expression m = value("m_" + called, b.mass, kind::mass);
    const vector to_center = symbols_along(called, axes, b.center);
    const auto inertia_value = [&](const char* prefix, double e) {
      return value(prefix + called, e, kind::moment_of_inertia);
    };
    const expression xx = inertia_value("ixx_", i.xx), yy = inertia_value("iyy_", i.yy),
                     zz = inertia_value("izz_", i.zz), xy = inertia_value("ixy_", i.xy),
                     yz = inertia_value("iyz_", i.yz), zx = inertia_value("izx_", i.zx);
    const bool is_at_origin = plan_.binds_numbers() && is_zero(b.center);
    const point_id center =
        is_at_origin ? origin(b.link) : offset(called + "_center", origin(b.link), to_center);
    weights_[b.link] = {m, center};
    rigid_body(called + "_body", center, axes, m, inertia(axes, xx, yy, zz, xy, yz, zx));
    if (is_unphysical(i)) effective_inertia(called + "_body");
  }

  /// Adds a rotor that turns n times as fast as the joint. It contributes n² J at the joint and nothing else.
  void add_rotor(const moving_body& b) {
    const joint& j = plan_.joint_of_body(b);
    if (!(j.reflected_inertia() > 0) || !has_one_coordinate(j.kind)) return;
    const std::string called = plan_.name(b.link) + "_rotor";
    const vector axis = along(inertial_frame(), 0, 0, 1);
    const frame_id axes = rotated(called, inertial_frame(), motion_of(b.joint).q[0], axis);
    const expression own = value("j_" + plan_.name(b.link), j.reflected_inertia(), kind::moment_of_inertia);
    rigid_body(called, origins_.back(), axes, number(0.0), inertia(axes, 0, 0, own));
  }

  void add_gravity(const vector3& g) {
    const bool numbers = plan_.binds_numbers();
    const vector to = along_numbers(inertial_frame(), numbers ? g : direction_of_gravity(g));
    const vector free_fall = numbers ? to : value("g", std::hypot(g[0], g[1], g[2]), kind::acceleration) * to;
    gravity(free_fall);
    if (numbers && is_zero(g)) return;
    expression energy{}; // one sum, because the wheels of an axle have equal terms
    for (const moving_body& b : plan_.tree.bodies) {
      if (!(b.weightless_mass > 0) || plan_.is_on_ground(b)) continue;
      const expression term = weight_cancelling_energy(b, free_fall);
      energy = energy.is_given() ? energy + term : term;
    }
    if (energy.is_given()) potential_energy(energy);
  }

  /// A potential energy that cancels gravity on a weightless body, so that energy is conserved.
  expression weight_cancelling_energy(const moving_body& b, const vector& free_fall) {
    weight lifted;
    if (b.is_weightless()) {
      lifted = weights_.at(b.link);
    } else {
      const std::string called = plan_.name(b.link) + "_weightless";
      lifted.mass = value("m_" + called, b.weightless_mass, kind::mass);
      lifted.center =
          offset(called, origin(b.link), symbols_along(called, frame(b.link), b.weightless_center));
    }
    return lifted.mass * builder::dot(free_fall, position_of(lifted.center, origins_.back()));
  }

  void place_fixed_links() {
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      const placed_link& here = plan_.tree.links[l];
      const int body = entry(plan_.tree.bodies, here.body).link;
      if (body == static_cast<int>(l)) continue;
      frames_[l] = rotated_frame(plan_.links[l], frame(body), here.pose_in_body.orientation);
      origins_[l] =
          offset_point(plan_.links[l] + "_origin", origin(body), frame(body), here.pose_in_body.position);
    }
  }

  robot robot_;
  robots::plan plan_;
  std::vector<motion> motions_{};
  std::vector<frame_id> frames_{}; ///< the frames of the links, then that of the ground
  std::vector<point_id> origins_{};
  std::map<std::string, std::size_t, std::less<>> index_by_name_{};
  std::vector<std::pair<std::string, double>> values_{};
  std::map<int, weight> weights_{}; ///< weights of the bodies, keyed by link
};

inline robot_builder::robot_builder(robot r, const model_options& options)
    : builder("N"), robot_(std::move(r)), plan_(plan_of(robot_, options)) {
  frames_.resize(robot_.links.size() + 1);
  origins_.resize(robot_.links.size() + 1);
  if (!plan_.mistake.empty()) {
    report(plan_.mistake);
    return;
  }
  for (std::size_t l = 0; l < robot_.links.size(); ++l) index_by_name_.emplace(robot_.links[l].name, l);
  add_symbols();
  add_root();
  for (std::size_t j = 0; j < motions_.size(); ++j) {
    if (plan_.joints[j].kind == joint_kind::floating) continue;
    const motion& m = motions_[j];
    for (std::size_t i = 0; i < m.q.size(); ++i) kinematic_equation(dot(m.q[i]) - m.u[i]);
  }
  for (const moving_body& b : plan_.tree.bodies) {
    if (b.joint >= 0) add_joint(b);
    if (b.joint >= 0) add_friction(b);
    if (b.joint >= 0) add_stops(b);
    add_mass(b);
    if (b.joint >= 0) add_rotor(b);
  }
  place_fixed_links();
  add_gravity(gravity_of(robot_, options));
  trust_units_of_present_parts(); // their numbers may be factors
}

} // namespace kanexpr::robots
