#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/orientation.hpp>

#include <string_view>

namespace kanexpr::derivation {

using describe::path_record;

/// Reads the pathways of loads.
class path_reader : part_reader {
public:
  constexpr explicit path_reader(const part_reader& parts) : part_reader(parts) {}

  /// Reports a type that is not a pathway, or a pathway with the wrong number of arguments; `whom` names the
  /// load.
  constexpr bool is_pathway(const path_record& r, std::string_view word) {
    if (r.what == path_word::none) {
      const bool is_kind = !r.instead.empty();
      reading_.fail({word, " acts along ", short_name(r.called).view(), ", which is ",
                     is_kind ? r.instead.substr(0, r.instead.find(';')) : "not a pathway",
                     is_kind ? ", not a pathway" : "", "; write straight<P, Q>, for example"});
    } else if (!r.fits) {
      const sentence pathway({"the pathway of ", word});
      reading_.fail_by_argument_count("", pathway.view(), r.fits);
    }
    return !reading_.mistake;
  }

  constexpr mechanics::pathway read(const path_record& r, std::string_view whom) {
    mechanics::pathway p;
    for (const describe::point_record& each : r.points)
      if (!reading_.mistake) p.points.push(entities_.point(&each, whom));
    switch (r.what) {
    case path_word::through_points:
    case path_word::none: p.form = pathway_form::through_points; break;
    case path_word::given_length:
      p.form = pathway_form::given_length;
      p.length = phrases_.scalar_of(r.length, {"the length of ", whom}, whom);
      break;
    case path_word::cylinder: read_surface(r, p, pathway_form::around_cylinder, whom); break;
    case path_word::sphere: read_surface(r, p, pathway_form::around_sphere, whom); break;
    case path_word::cone: read_surface(r, p, pathway_form::around_cone, whom); break;
    }
    return p;
  }

private:
  using path_word = describe::path_word;
  using pathway_form = mechanics::pathway_form;

  constexpr void read_surface(const path_record& r, mechanics::pathway& p, pathway_form form,
                              std::string_view whom) {
    p.form = form;
    if (!reading_.mistake) p.center = entities_.point(r.center, whom);
    p.frame = mechanism::inertial;
    mechanics::wrapped_surface& s = p.surface;
    s.sense = r.sense == wrapping::counterclockwise ? 1 : -1;
    s.first_is_on_surface = r.first_is_on_surface, s.last_is_on_surface = r.last_is_on_surface;
    s.size = phrases_.scalar_of(r.size, {"the surface of ", whom}, whom);
    s.axis = mechanics::components(*m_.g);
    if (form == pathway_form::around_sphere || reading_.mistake) return;
    p.frame = entities_.frame(r.frame, whom);
    const mechanics::vector axis = phrases_.vector_of(r.axis, {"the axis of ", whom}, whom);
    if (reading_.mistake) return;
    s.axis = mechanics::express(m_, axis, p.frame);
    if (s.axis.is_zero()) return reading_.fail({whom, " is wrapped around an axis of zero length"});
    if (!mechanics::is_fixed(s.axis))
      return reading_.fail({whom, " is wrapped around an axis that is not fixed in ", r.frame->called});
    s.axis = mechanics::unit_along(s.axis);
  }
};

} // namespace kanexpr::derivation
