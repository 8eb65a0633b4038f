#pragma once

#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/numeric/taut_line.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

/// The lines along which the pathways of a model are drawn.
namespace kanexpr::figures {

/// The surface around which a pathway is wrapped, at a configuration.
inline numeric::wrapped_surface surface_of(const mechanics::pathway& p, const Eigen::Vector3d& center,
                                           const Eigen::Vector3d& axis, double size) {
  using mechanics::pathway_form;
  numeric::wrapped_surface s;
  s.form = p.form == pathway_form::around_cylinder ? numeric::wrapped_solid::cylinder
           : p.form == pathway_form::around_sphere ? numeric::wrapped_solid::sphere
                                                   : numeric::wrapped_solid::cone;
  s.center = center, s.axis = axis, s.size = size;
  s.sense = p.surface.sense;
  s.first_is_on_surface = p.surface.first_is_on_surface, s.last_is_on_surface = p.surface.last_is_on_surface;
  return s;
}

/// The line of a pathway around a surface or through points, whose positions `place` returns; empty if only
/// the length of the pathway is given.
template <class Place>
numeric::taut_line line_along(const mechanics::pathway& p, const numeric::wrapped_surface& around,
                              const Place& place) {
  if (p.is_around_surface()) return numeric::line_around(around, place(p.points[0]), place(p.points.back()));
  std::vector<Eigen::Vector3d> places;
  places.reserve(static_cast<std::size_t>(p.points.size()));
  for (const int point : p.points) places.push_back(place(point));
  return numeric::straight_lines(std::move(places));
}

} // namespace kanexpr::figures
