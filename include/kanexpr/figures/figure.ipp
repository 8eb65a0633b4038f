#pragma once

#include <kanexpr/figures/drawing.ipp>
#include <kanexpr/figures/figure.hpp>

#include <fstream>

namespace kanexpr {

KANEXPR_ENGINE status figure::write(const std::string& file) const {
  if (!*this) return status(cause_);
  std::ofstream out(file, std::ios::binary);
  out << svg_;
  out.close();
  return out ? status() : status(base::sentence({"the figure cannot be written to ", file}).view());
}

KANEXPR_ENGINE figure draw(model& m, given_state<model> x, given_parameters<model> p, given_inputs<model> r,
                           const figure_options& how) {
  if (const std::string mistake = m.mistake(); !mistake.empty()) return figure::refused(mistake);
  x.read(m.known()), p.read(m.known()), r.read(m.known());
  for (const base::sentence& mistake : {x.mistake, p.mistake})
    if (mistake) return figure::refused(std::string(mistake.view()));
  const figures::geometry at = figures::geometry_of(m, 0, x.values, p.values, r.values);
  if (!at.status) return figure::refused(at.status.cause());
  for (const Eigen::Vector3d& each : at.points)
    if (!each.allFinite())
      return figure::refused("the position of a point is not finite; give all parameters values");
  figures::view seen = how.upward ? figures::view_of(at, *how.upward) : figures::view_of(at);
  if (how.eye) seen = figures::detail::view_along(how.eye->normalized(), seen.up);
  figures::drawing shown(m.system(), at, seen);
  shown.draw_bodies();
  shown.draw_links(how.lengths);
  shown.draw_points(how.names);
  if (how.axes) shown.draw_axes();
  if (how.angles) shown.draw_angles();
  if (how.loads) shown.draw_loads(), shown.draw_gravity();
  return figure(shown.on.svg(how.title.empty() ? "The model" : how.title));
}

} // namespace kanexpr
