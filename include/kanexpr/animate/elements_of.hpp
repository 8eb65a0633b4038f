#pragma once

#include <kanexpr/animate/attachment.hpp>
#include <kanexpr/animate/elements.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/describe/load.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/system.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

/// The elements of a picture, in which `show_forces`, `show_velocities` and `show_frames` are replaced by one
/// element for each load or body of the model.
namespace kanexpr::animate {

template <class... Elements>
struct element_list {};

namespace detail {

using describe::body_record;
using describe::load_record;
using describe::token;
using describe::token_kind;

/// The bodies of a system, including those of its joints.
template <class System>
struct bodies_of {
  static constexpr const auto& record = System::record;
  static constexpr std::size_t most = static_cast<std::size_t>(record.bodies.size + record.joints.size) + 1;
  struct list {
    std::array<const body_record*, most> all{};
    std::size_t count = 0;
  };
  static constexpr list found = [] {
    list l;
    for (const body_record& b : record.bodies) l.all[l.count++] = &b;
    for (const describe::joint_record& j : record.joints)
      if (j.body != nullptr) l.all[l.count++] = j.body;
    return l;
  }();
};

/// An end of a line along which a load pulls.
struct pulled_end {
  const load_record* load = nullptr;
  const describe::point_record* point = nullptr;
  const describe::point_record* toward = nullptr; ///< the next point of the line
};

/// Stores the two ends of the line along which a load pulls in `found` and returns their number; 0 if the
/// load does not pull along straight lines between points.
constexpr int ends_of_line(const load_record& r, pulled_end* found) {
  using enum describe::load_word;
  if (r.what == spring || r.what == damper) {
    found[0] = {&r, r.point, r.other_point}, found[1] = {&r, r.other_point, r.point};
    return 2;
  }
  if (r.path == nullptr || r.path->what != describe::path_word::through_points || r.path->points.size < 2)
    return 0;
  const auto& points = r.path->points;
  const int last = points.size - 1;
  found[0] = {&r, &points[0], &points[1]}, found[1] = {&r, &points[last], &points[last - 1]};
  return 2;
}

/// The forces, contacts and tensions among the loads of a system, and its gravity. A force between two points
/// counts twice.
template <class System>
struct forces_of {
  static constexpr const auto& record = System::record;
  struct force {
    const load_record* load = nullptr;
    bool is_opposite = false;
  };
  struct list {
    std::array<force, 2 * static_cast<std::size_t>(record.loads.size) + 1> all{};
    std::size_t count = 0;
    std::array<const load_record*, static_cast<std::size_t>(record.loads.size) + 1> contacts{};
    std::size_t contact_count = 0;
    std::array<pulled_end, 2 * static_cast<std::size_t>(record.loads.size) + 2> ends{};
    std::size_t end_count = 0;
    const load_record* gravity = nullptr;
  };
  static constexpr list found = [] {
    list l;
    for (const load_record& r : record.loads) {
      if (r.what == describe::load_word::gravity) l.gravity = &r;
      if (r.what == describe::load_word::contact) l.contacts[l.contact_count++] = &r;
      l.end_count += static_cast<std::size_t>(ends_of_line(r, &l.ends[l.end_count]));
      if (r.what != describe::load_word::force) continue;
      l.all[l.count++] = {&r, false};
      if (r.other_point != nullptr) l.all[l.count++] = {&r, true};
    }
    return l;
  }();
};

constexpr token token_of(token_kind what, const describe::point_record* point) {
  token t = describe::with(what);
  t.point = point;
  return t;
}
constexpr token axis_of(const describe::frame_record* frame, int index) {
  token t = describe::with(token_kind::basis);
  t.frame = frame;
  t.index = index;
  return t;
}

constexpr base::name title(std::string_view what, std::string_view whose) {
  base::name all;
  all.append(what), all.append(whose);
  return all;
}

/// The parts that shapes from the records of a model have in common.
struct shape_of_model : element {
  static constexpr std::string_view word = "show";
  static constexpr phrases<0> sizes{};
};

/// The weight of a body: its mass times the acceleration of gravity.
template <class System, std::size_t index>
struct weight : shape_of_model {
  static constexpr const body_record& body = *bodies_of<System>::found.all[index];
  static constexpr const phrase& gravity = forces_of<System>::found.gravity->value;
  static constexpr base::name called = title("weight of ", body.called);
  static constexpr token position[]{token_of(token_kind::position, body.center)};
  static constexpr auto product = [] {
    std::array<token, static_cast<std::size_t>(body.mass.size + gravity.size) + 1> all{};
    std::size_t next = 0;
    for (const token& t : body.mass) all[next++] = t;
    for (const token& t : gravity) all[next++] = t;
    all[next] = describe::with(token_kind::multiply);
    return all;
  }();
  static constexpr phrases<2> varying{
      phrase{shape::vector, position, 1},
      phrase{shape::vector, product.data(), static_cast<int>(product.size())}};
  static constexpr const describe::point_record* point = body.center;
};

/// A force among the loads of the model.
template <class System, std::size_t index>
struct applied_force : shape_of_model {
  static constexpr const auto& force = forces_of<System>::found.all[index];
  static constexpr const load_record& load = *force.load;
  static constexpr const describe::point_record* point = force.is_opposite ? load.other_point : load.point;
  static constexpr std::string_view kind = load.word.substr(4); // without "the "
  static constexpr base::name called = title(title(kind, " at ").view(), point->called);
  static constexpr token position[]{token_of(token_kind::position, point)};
  static constexpr auto vector = [] {
    std::array<token, static_cast<std::size_t>(load.value.size) + (force.is_opposite ? 1 : 0)> all{};
    std::size_t next = 0;
    for (const token& t : load.value) all[next++] = t;
    if (force.is_opposite) all[next] = describe::with(token_kind::negate);
    return all;
  }();
  static constexpr phrases<2> varying{phrase{shape::vector, position, 1},
                                      phrase{shape::vector, vector.data(), static_cast<int>(vector.size())}};
};

/// The force of a contact on its first body, at the contact.
template <class System, std::size_t index>
struct contact_force : shape_of_model {
  static constexpr const load_record& load = *forces_of<System>::found.contacts[index];
  static constexpr const describe::point_record* point = load.point;
  static constexpr base::name called = title("contact force at ", point->called);
  static constexpr token tokens[]{token_of(token_kind::position, point),
                                  describe::of_load(describe::load_quantity::contact_place, &load, false),
                                  describe::with(token_kind::add),
                                  describe::of_load(describe::load_quantity::contact_force, &load, false)};
  static constexpr phrases<2> varying{phrase{shape::vector, tokens, 3}, phrase{shape::vector, tokens + 3, 1}};
};

/// The force of a load along a line on one of its ends: the tension, toward the next point of the line.
template <class System, std::size_t index>
struct tension_at_end : shape_of_model {
  static constexpr const pulled_end& end = forces_of<System>::found.ends[index];
  static constexpr const describe::point_record* point = end.point;
  static constexpr base::name called = title("tension at ", point->called);
  static constexpr token tokens[]{token_of(token_kind::position, point),
                                  describe::of_load(describe::load_quantity::tension, end.load, false),
                                  token_of(token_kind::position, end.toward),
                                  token_of(token_kind::position, point),
                                  describe::with(token_kind::subtract),
                                  describe::with(token_kind::normalized),
                                  describe::with(token_kind::multiply)};
  static constexpr phrases<2> varying{phrase{shape::vector, tokens, 1}, phrase{shape::vector, tokens + 1, 6}};
};

/// The velocity of the mass center of a body.
template <class System, std::size_t index>
struct velocity_of_body : shape_of_model {
  static constexpr const body_record& body = *bodies_of<System>::found.all[index];
  static constexpr base::name called = title("velocity of ", body.called);
  static constexpr token tokens[]{token_of(token_kind::position, body.center),
                                  token_of(token_kind::velocity, body.center)};
  static constexpr phrases<2> varying{phrase{shape::vector, tokens, 1}, phrase{shape::vector, tokens + 1, 1}};
  static constexpr const describe::point_record* point = body.center;
};

/// An arrow in a layer.
template <class Vector, class Layer>
struct arrow_of_model : Vector {
  static constexpr animate::look look{
      .name = Vector::called.view(), .layer = Layer::name, .unit = Layer::unit};
  struct attachment {
    static constexpr std::string_view shape = "arrow";
    static constexpr placement_kind placed_by = placement_kind::ends;
    static constexpr const describe::point_record* points[]{Vector::point};
  };
};

/// The axes of a rigid body at its mass center.
template <class System, std::size_t index>
struct frame_of_body : shape_of_model {
  static constexpr const body_record& body = *bodies_of<System>::found.all[index];
  static constexpr base::name called = title("axes of ", body.frame->called);
  static constexpr token tokens[]{token_of(token_kind::position, body.center), axis_of(body.frame, 0),
                                  axis_of(body.frame, 1)};
  static constexpr phrases<3> varying{phrase{shape::vector, tokens, 1}, phrase{shape::vector, tokens + 1, 1},
                                      phrase{shape::vector, tokens + 2, 1}};
  static constexpr animate::look look{.name = called.view(), .layer = "Frames"};
  struct attachment {
    static constexpr std::string_view shape = "frame";
    static constexpr placement_kind placed_by = placement_kind::pose;
    static constexpr const describe::point_record* points[]{body.center};
  };
};

template <text of_unit>
struct force_layer {
  static constexpr std::string_view name = "Forces", unit = of_unit.view();
};
template <text of_unit>
struct velocity_layer {
  static constexpr std::string_view name = "Velocities", unit = of_unit.view();
};

template <class... Lists>
struct joined {
  using list = element_list<>;
};
template <class... First>
struct joined<element_list<First...>> {
  using list = element_list<First...>;
};
template <class... First, class... Second, class... Lists>
struct joined<element_list<First...>, element_list<Second...>, Lists...>
    : joined<element_list<First..., Second...>, Lists...> {};

template <class System, class Element>
struct expanded {
  using list = element_list<Element>;
};

template <class System, text of_unit>
struct expanded<System, show_forces<of_unit>> {
  template <std::size_t... i>
  static element_list<arrow_of_model<applied_force<System, i>, force_layer<of_unit>>...>
      loads(std::index_sequence<i...>);
  template <std::size_t... i>
  static element_list<arrow_of_model<weight<System, i>, force_layer<of_unit>>...>
      weights(std::index_sequence<i...>);
  template <std::size_t... i>
  static element_list<arrow_of_model<contact_force<System, i>, force_layer<of_unit>>...>
      contacts(std::index_sequence<i...>);
  template <std::size_t... i>
  static element_list<arrow_of_model<tension_at_end<System, i>, force_layer<of_unit>>...>
      tensions(std::index_sequence<i...>);
  static constexpr std::size_t weighed =
      forces_of<System>::found.gravity == nullptr ? 0 : bodies_of<System>::found.count;
  using list =
      typename joined<decltype(loads(std::make_index_sequence<forces_of<System>::found.count>{})),
                      decltype(contacts(std::make_index_sequence<forces_of<System>::found.contact_count>{})),
                      decltype(tensions(std::make_index_sequence<forces_of<System>::found.end_count>{})),
                      decltype(weights(std::make_index_sequence<weighed>{}))>::list;
};

template <class System, text of_unit>
struct expanded<System, show_velocities<of_unit>> {
  template <std::size_t... i>
  static element_list<arrow_of_model<velocity_of_body<System, i>, velocity_layer<of_unit>>...>
      velocities(std::index_sequence<i...>);
  using list = decltype(velocities(std::make_index_sequence<bodies_of<System>::found.count>{}));
};

template <class System>
struct expanded<System, show_frames> {
  template <std::size_t i>
  using axes_or_none = std::conditional_t<bodies_of<System>::found.all[i]->rigid,
                                          element_list<frame_of_body<System, i>>, element_list<>>;
  template <std::size_t... i>
  static typename joined<element_list<>, axes_or_none<i>...>::list axes(std::index_sequence<i...>);
  using list = decltype(axes(std::make_index_sequence<bodies_of<System>::found.count>{}));
};

template <class Element>
inline constexpr bool is_expanded = std::is_same_v<Element, show_frames>;
template <text of_unit>
inline constexpr bool is_expanded<show_forces<of_unit>> = true;
template <text of_unit>
inline constexpr bool is_expanded<show_velocities<of_unit>> = true;

template <bool any, class System, class... Elements>
struct whole_list {
  using list = element_list<Elements...>;
};
template <class System, class... Elements>
struct whole_list<true, System, Elements...> : joined<typename expanded<System, Elements>::list...> {};

} // namespace detail

template <class System, class... Elements>
using elements_of =
    typename detail::whole_list<(detail::is_expanded<Elements> || ...), System, Elements...>::list;

} // namespace kanexpr::animate
