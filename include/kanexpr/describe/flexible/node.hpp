#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/beams/section.hpp>
#include <kanexpr/describe/body.hpp>
#include <kanexpr/describe/flexible/flexible_body.hpp>
#include <kanexpr/describe/frame.hpp>
#include <kanexpr/describe/point.hpp>
#include <kanexpr/symbolic/numbers/number.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace kanexpr {

namespace describe {

/// The name of a node, which a model gives as text or as a number.
struct node_name {
  base::name called{};

  constexpr node_name(int number) { called.append(number); }
  template <std::size_t size>
  constexpr node_name(const char (&literal)[size]) : called(std::string_view(literal, size - 1)) {}
  constexpr std::string_view view() const { return called.view(); }
};

/// The place of a node, as expressions of the amplitudes.
template <class Body, int index>
class place_of_node {
  static constexpr auto amplitudes = []<std::size_t... k>(std::index_sequence<k...>) {
    return std::array<token, sizeof...(k)>{Body::template q<k>.tokens[0]...};
  }(std::make_index_sequence<Body::coordinates_count>());
  static constexpr int count = static_cast<int>(Body::coordinates_count);
  static constexpr const auto& node = Body::data.nodes[index];

  static constexpr bool is_zero(double value) { return value * value <= 0; }
  static constexpr void write_number(token_writer& to, double value) {
    token t{};
    t.number = symbolic::real(value);
    to.write(t);
  }
  static constexpr void write_amplitude(token_writer& to, int k) {
    to.write(amplitudes[static_cast<std::size_t>(k)]);
  }
  /// Writes c_k + Σ c_kl q_l over l ≤ k, with half of c_kk.
  static constexpr bool write_factor(token_writer& to, int k, int i) {
    const double* const second = node.position + 3 * (1 + count) + 3 * count * k;
    written_sum sum(to);
    if (const double first = node.position[3 * (1 + k) + i]; !is_zero(first)) {
      write_number(to, first);
      sum.add_term();
    }
    for (int l = 0; l <= k; ++l) {
      const double value = second[3 * l + i] / (l == k ? 2 : 1);
      if (is_zero(value)) continue;
      write_number(to, value);
      write_amplitude(to, l);
      to.write(token_kind::multiply);
      sum.add_term();
    }
    return !sum.is_empty();
  }

  static constexpr void write_component(token_writer& to, int i) {
    written_sum sum(to);
    if (!is_zero(node.position[i])) {
      write_number(to, node.position[i]);
      sum.add_term();
    }
    for (int k = 0; k < count; ++k) {
      token_writer trial;
      if (!write_factor(trial, k, i)) continue;
      write_amplitude(to, k);
      write_factor(to, k, i);
      to.write(token_kind::multiply);
      sum.add_term();
    }
    if (sum.is_empty()) write_number(to, 0);
  }

public:
  /// The position from the reference point, in the axes of a frame.
  static constexpr void write_offset(token_writer& to) {
    for (int i = 0; i < 3; ++i) {
      write_component(to, i);
      to.write_all(basis(&frame_of<typename Body::base_frame>, i));
      to.write(token_kind::multiply);
      if (i > 0) to.write(token_kind::add);
    }
  }

  /// A modified Rodrigues parameter of the rotation of the node.
  static constexpr void write_turn(token_writer& to, int i) {
    written_sum sum(to);
    for (int k = 0; k < count; ++k) {
      const double value = node.rotation[3 * k + i] / 4;
      if (is_zero(value)) continue;
      write_number(to, value);
      write_amplitude(to, k);
      to.write(token_kind::multiply);
      sum.add_term();
    }
    for (int k = 0; k < count; ++k)
      for (int l = 0; l <= k; ++l) {
        const double value = node.second_rotation[3 * (k * count + l) + i] / (l == k ? 8 : 4);
        if (is_zero(value)) continue;
        write_number(to, value);
        write_amplitude(to, k);
        write_amplitude(to, l);
        to.write(token_kind::multiply);
        to.write(token_kind::multiply);
        sum.add_term();
      }
    if (sum.is_empty()) write_number(to, 0);
  }

  static constexpr void write_cosine(token_writer& to, int e) { write_number(to, node.orientation[e]); }

  /// Whether the axes of the node are those of the body's frame before the deformation.
  static constexpr bool is_aligned() {
    for (int e = 0; e < 9; ++e)
      if (!is_zero(node.orientation[e] - (e % 4 == 0 ? 1 : 0))) return false;
    return true;
  }
};

template <class Body>
concept flexible_body_without_mistake = requires { requires Body::flexible_description().mistake.empty(); };

/// Sets the entries of an orientation, each written by its own function.
template <class Place, std::size_t... i>
constexpr void turn_with_node(frame_record& r, std::index_sequence<i...>) {
  r.orientation = orientation_word::modified_rodrigues;
  r.given_as = "the rotation of node ";
  ((r.given[i] =
        written_phrase<[](token_writer& to) { Place::write_turn(to, static_cast<int>(i)); }>(shape::scalar)),
   ...);
}
template <class Place, std::size_t... e>
constexpr void align_with_node(frame_record& r, std::index_sequence<e...>) {
  r.orientation = orientation_word::direction_cosines;
  r.given_as = "the orientation of node ";
  ((r.given[e] = written_phrase<[](token_writer& to) { Place::write_cosine(to, static_cast<int>(e)); }>(
        shape::scalar)),
   ...);
}

/// The frame of a node before the rotation from the axes of the body to its own.
template <class Self, class Body, int index>
inline constexpr frame_record turned_frame_of_node = [] {
  frame_record r;
  r.called = r.declared_name = joint_name<"", Self, "turned">.view();
  r.parent = &frame_of<typename Body::base_frame>;
  turn_with_node<place_of_node<Body, index>>(r, std::make_index_sequence<3>());
  return r;
}();

} // namespace describe

/// A node of a flexible body, with the name or number that its file gives: `struct Tip : node<Tip, Panel, 12>
/// {};` A node is a frame and a point: joints are attached to it and loads act on it. Its frame is rotated by
/// the rotation vector that the shapes give at the node, to the second order.
template <class Self, class Body, describe::node_name called>
struct node : describe::axes<Self>, describe::place_words, describe::node_words {
  static constexpr describe::frame_record orientation() {
    describe::frame_record r;
    r.declared_name = type_name<Self>();
    r.on_flexible = &describe::body_of<Body>;
    r.missing_node = is_known ? std::string_view() : name_in_message.view();
    if constexpr (is_known) {
      using place = describe::place_of_node<Body, index>;
      if constexpr (place::is_aligned()) {
        r.parent = &describe::frame_of<typename Body::base_frame>;
        describe::turn_with_node<place>(r, std::make_index_sequence<3>());
      } else {
        r.parent = &describe::turned_frame_of_node<Self, Body, index>;
        describe::align_with_node<place>(r, std::make_index_sequence<9>());
      }
    }
    return r;
  }

  static constexpr describe::point_record place() {
    describe::point_record r;
    r.declared_name = type_name<Self>();
    r.on_flexible = &describe::body_of<Body>;
    if constexpr (is_known) {
      constexpr auto write = [](describe::token_writer& to) {
        describe::place_of_node<Body, index>::write_offset(to);
      };
      r.parent = &describe::point_of<typename Body::base_point>;
      r.offset = describe::written_phrase<write>(describe::shape::vector);
    } else {
      r.missing_node = name_in_message.view();
    }
    return r;
  }

private:
  static constexpr describe::node_name name_in_message = called;
  static constexpr int index = [] {
    if constexpr (describe::flexible_body_without_mistake<Body>)
      return Body::data.find_node(called.called);
    else
      return -1;
  }();
  static constexpr bool is_known = index >= 0;
};

} // namespace kanexpr
