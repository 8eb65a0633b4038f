#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/contact_record.hpp>
#include <kanexpr/describe/letters_of_name.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/mechanics/loads/contact_shapes.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <cstddef>
#include <string_view>

/// The state variables of laws of friction with bristles, which are named after the joint, the ends of the
/// pathway or the points of the contact on which the friction acts.
namespace kanexpr {

namespace describe {

template <class On>
concept lays_out_contact = requires(contact_record& r) { On::lay_out(r); };

/// The names after which the bristles of a joint, a pathway or the shapes of a contact are called; the first
/// is empty if there is none.
struct names_of_bristles {
  std::string_view first{}, second{};
};

template <class On>
constexpr names_of_bristles names_of_bristles_on() {
  if constexpr (lays_out_contact<On>) {
    contact_record r;
    On::lay_out(r);
    return {r.point->called, r.other_point->called};
  } else if constexpr (requires { On::path.points; }) {
    const listing<point_record>& points = On::path.points;
    if (points.size == 0) return {};
    return {points[0].called, points[points.size - 1].called};
  } else {
    return {type_name<On>()};
  }
}

/// The number of bristles: one for each direction of slip.
template <class On>
constexpr int count_bristles() {
  if constexpr (lays_out_contact<On>) {
    contact_record r;
    On::lay_out(r);
    return r.shapes == mechanics::contact_shapes::sphere_on_plane ||
                   r.shapes == mechanics::contact_shapes::torus_on_plane
               ? 2
               : 3;
  } else {
    return 1;
  }
}

/// Visits the letters of the name of a bristle: z_Joint, z_P_Q, or z1_P_Q and z2_P_Q in a contact.
template <class On, int index, class Visit>
constexpr void each_letter_of_bristle(Visit visit) {
  const names_of_bristles names = names_of_bristles_on<On>();
  visit('z');
  if (lays_out_contact<On>) visit(static_cast<char>('0' + index));
  for (const std::string_view name : {names.first, names.second}) {
    if (name.empty()) continue;
    visit('_');
    each_letter_of_name(name, visit);
  }
}

template <class On, int index>
inline constexpr std::size_t size_of_bristle_name = [] {
  std::size_t size = 0;
  each_letter_of_bristle<On, index>([&](char) { ++size; });
  return size;
}();

template <class On, int index>
inline constexpr auto name_of_bristle = [] {
  text<size_of_bristle_name<On, index> + 1> all;
  char* to = all.letters;
  each_letter_of_bristle<On, index>([&](char c) { *to++ = c; });
  return all;
}();

} // namespace describe

/// The deflection of the bristles of a law of friction with bristles, a state variable: z_Link2 of
/// `bristle_of<Link2>` in a joint, z_P_Q of `bristle_of<straight<P, Q>>` along a pathway. In a contact, there
/// is one for each direction of slip, two on a plane and three otherwise: z1_P_Q and z2_P_Q of
/// `bristle_of<point_on_plane<P, Q, N::z>, 1>` and `bristle_of<point_on_plane<P, Q, N::z>, 2>`.
template <class On, int index = 1>
inline constexpr describe::symbol<symbolic::symbol_kind::speed, describe::name_of_bristle<On, index>,
                                  unnumbered, describe::of_state_variable>
    bristle_of{};

namespace describe {

template <class On, int count = count_bristles<On>()>
inline constexpr listing<phrase> bristles_on{};
template <class On>
inline constexpr listing<phrase> bristles_on<On, 1> = list_of<phrase, &phrase_of<bristle_of<On>>>::all;
template <class On>
inline constexpr listing<phrase> bristles_on<On, 2> =
    list_of<phrase, &phrase_of<bristle_of<On, 1>>, &phrase_of<bristle_of<On, 2>>>::all;
template <class On>
inline constexpr listing<phrase> bristles_on<On, 3> =
    list_of<phrase, &phrase_of<bristle_of<On, 1>>, &phrase_of<bristle_of<On, 2>>,
            &phrase_of<bristle_of<On, 3>>>::all;

} // namespace describe

} // namespace kanexpr
