#pragma once

#include <kanexpr/figures/drawing.hpp>
#include <kanexpr/figures/pathways.hpp>
#include <kanexpr/mechanics/loads/path_load.hpp>
#include <kanexpr/numeric/taut_line.hpp>

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::figures {

namespace detail {

/// A unit vector perpendicular to a given one.
inline Eigen::Vector3d across(const Eigen::Vector3d& v) {
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return v.cross(Eigen::Vector3d::Unit(least)).normalized();
}

} // namespace detail

/// The only component of a load. If there are several, or if its text is long, a name for the load; none if
/// the name belongs to a symbol.
inline text label_of_load(const drawing& d, const mechanics::vector& value, std::string_view otherwise) {
  constexpr std::size_t longest = 24;
  const detail::single_component along = detail::single_component_of(value);
  const std::string component = along.axis == detail::no_axis ? std::string() : d.name_of_size(along.value);
  if (!component.empty() && component.size() <= longest) return typeset(component);
  return d.has_symbol(otherwise) ? text() : typeset(otherwise);
}

inline void draw_force(drawing& d, int i) {
  const mechanics::force& each = d.system.loads.forces[i];
  const Eigen::Vector2d along = d.seen(d.at.forces[static_cast<std::size_t>(i)].stableNormalized());
  if (along.norm() < 0.05) return;
  const Eigen::Vector2d here = d.picture(each.point), tip = here + 58 * along;
  d.on.arrow(layer::axes, here, tip, "load");
  d.on.label(tip, along, label_of_load(d, each.value, "F"), "load");
}

inline void draw_torque(drawing& d, int i) {
  const mechanics::torque& each = d.system.loads.torques[i];
  const int place = d.place_of_frame[static_cast<std::size_t>(each.frame)];
  const Eigen::Vector3d about = d.at.torques[static_cast<std::size_t>(i)].stableNormalized();
  if (place == mechanics::none || about.isZero()) return;
  const Eigen::Vector3d start = detail::across(about);
  std::vector<Eigen::Vector2d> through;
  constexpr int pieces = 24;
  for (int k = 0; k <= pieces; ++k) {
    const double turned = (0.3 + 1.2 * k / pieces) * std::numbers::pi;
    through.push_back(d.picture(place) + 20 * d.seen(Eigen::AngleAxisd(turned, about) * start));
  }
  d.on.path(layer::axes, through, "load", 8);
  d.on.label(through[pieces / 2], through[pieces / 2] - d.picture(place), label_of_load(d, each.value, "τ"),
             "load");
}

inline void draw_spring(drawing& d, const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                        const Eigen::Vector2d& aside) {
  std::vector<Eigen::Vector2d> zigzag{from, from + 0.15 * along};
  for (int k = 0; k < 9; ++k)
    zigzag.push_back(from + (0.19 + 0.0775 * k) * along + (k % 2 == 0 ? 1 : -1) * aside);
  zigzag.push_back(from + 0.85 * along), zigzag.push_back(from + along);
  d.on.path(layer::axes, zigzag, "load");
}

inline void draw_damper(drawing& d, const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                        const Eigen::Vector2d& aside) {
  const Eigen::Vector2d piston = from + 0.5 * along, open = from + 0.42 * along, closed = from + 0.62 * along;
  d.on.line(layer::axes, from, piston, "load");
  d.on.line(layer::axes, piston + 0.8 * aside, piston - 0.8 * aside, "load");
  d.on.path(layer::axes, {open + aside, closed + aside, closed - aside, open - aside}, "load");
  d.on.line(layer::axes, closed, from + along, "load");
}

/// The value that determines the tension of a load along a pathway; none for a stop.
inline text label_of_path_load(const mechanics::path_load& each) {
  using mechanics::tension_law;
  const bool is_cubic = each.law == tension_law::spring && each.terms[0].is_zero();
  if (each.law == tension_law::stop || each.law == tension_law::friction) return {};
  return typeset(drawing::name_of_size(each.terms[is_cubic ? 1 : 0]));
}

/// A load along a pathway is drawn as the line of the pathway.
inline void draw_path_load(drawing& d, const mechanics::path_load& each, int i) {
  const numeric::taut_line line =
      line_along(each.along, d.at.surfaces[static_cast<std::size_t>(i)],
                 [&](int point) { return d.at.points[static_cast<std::size_t>(point)]; });
  if (line.places.size() < 2) return;
  std::vector<Eigen::Vector2d> through;
  through.reserve(line.places.size());
  for (const Eigen::Vector3d& place : line.places) through.push_back(d.picture(place));
  d.on.path(layer::axes, through, "load");
  const std::size_t middle = (through.size() - 1) / 2;
  const Eigen::Vector2d along = through[middle + 1] - through[middle];
  d.on.label((through[middle] + through[middle + 1]) / 2, Eigen::Vector2d(-along(1), along(0)),
             label_of_path_load(each), "load", 6);
}

inline void draw_loads(drawing& d) {
  for (int i = 0; i < d.system.loads.forces.size(); ++i) draw_force(d, i);
  for (int i = 0; i < d.system.loads.torques.size(); ++i) draw_torque(d, i);
  const base::sequence<mechanics::path_load> path_loads = d.system.loads.all<mechanics::path_load>();
  for (int i = 0; i < path_loads.size(); ++i) draw_path_load(d, path_loads[i], i);
  for (const mechanics::spring_damper& each : d.system.loads.spring_dampers) {
    const Eigen::Vector2d from = d.picture(each.point), along = d.picture(each.against) - from;
    if (along.norm() < 4) continue;
    const Eigen::Vector2d aside = 6 * Eigen::Vector2d(-along(1), along(0)).normalized();
    const bool has_spring = !each.stiffness.is_zero(), has_damper = !each.damping.is_zero();
    const bool has_both = has_spring && has_damper;
    const Eigen::Vector2d apart = has_both ? Eigen::Vector2d(1.4 * aside) : Eigen::Vector2d(0, 0);
    for (const Eigen::Vector2d& end : {from, Eigen::Vector2d(from + along)})
      if (has_both) d.on.line(layer::axes, end + apart, end - apart, "load");
    if (has_spring) {
      draw_spring(d, from + apart, along, aside);
      d.on.label(from + along / 2 + apart, aside, typeset(d.name_of_size(each.stiffness)), "load", 6);
    }
    if (has_damper) {
      draw_damper(d, from - apart, along, aside);
      d.on.label(from + along / 2 - apart, -aside, typeset(d.name_of_size(each.damping)), "load", 6);
    }
  }
}

inline void draw_gravity(drawing& d) {
  const Eigen::Vector2d along = d.seen(d.at.gravity.stableNormalized());
  if (along.norm() < 0.05) return;
  const detail::single_component value = detail::single_component_of(d.system.loads.gravity);
  const Eigen::Vector2d from(d.on.most()(0) + 48, d.on.most()(1) - 6), to = from + 44 * along;
  d.on.arrow(layer::axes, from, to, "load");
  const std::string called = value.axis == detail::no_axis ? "g" : d.name_of_size(value.value);
  d.on.label((from + to) / 2, {1, 0}, typeset(called), "load");
}

} // namespace kanexpr::figures
