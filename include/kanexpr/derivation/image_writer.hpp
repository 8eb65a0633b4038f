#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/image.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <optional>
#include <type_traits>

namespace kanexpr::derivation {

/// Writes a derivation into an image: `write(part)` for each part, which `image_reader` reads in the same
/// order.
class image_writer {
public:
  constexpr image_writer(image& into, const symbolic::graph& g);

  template <class Part>
  constexpr void operator()(const Part& part) {
    if constexpr (std::is_integral_v<Part> || std::is_enum_v<Part>)
      write(static_cast<int>(part));
    else if constexpr (requires { Part::each_member(part, *this); })
      Part::each_member(part, *this);
    else
      for_each_member(part, *this);
  }
  template <class... Parts>
    requires(sizeof...(Parts) > 1)
  constexpr void operator()(const Parts&... parts) {
    ((*this)(parts), ...);
  }
  template <class Part>
  constexpr void operator()(const base::sequence<Part>& parts) {
    write(parts.size());
    for (const Part& each : parts) (*this)(each);
  }
  template <class Part>
  constexpr void operator()(const std::optional<Part>& part) {
    write(part.has_value());
    if (part.has_value()) (*this)(*part);
  }
  constexpr void operator()(const base::sequence<symbolic::expression>& all) { // most of the content
    write(all.size());
    if (into_.integers + all.size() > image::most_integers) {
      into_.is_full = true;
      return;
    }
    for (const symbolic::expression& e : all)
      into_.integer[into_.integers++] = e.is_given() ? e.node() : none;
  }
  constexpr void operator()(const symbolic::expression& e) { write(e.is_given() ? e.node() : none); }
  constexpr void operator()(const base::name& called) {
    write(called.length);
    for (int i = 0; i < called.length; ++i) write(called.letters[i]);
  }
  constexpr void operator()(const describe::frame_record* const& r) {
    if (has_room(into_.frames, image::most_entities)) into_.frame[into_.frames++] = r;
  }
  constexpr void operator()(const describe::point_record* const& r) {
    if (has_room(into_.points, image::most_entities)) into_.point[into_.points++] = r;
  }
  constexpr void operator()(const mechanics::mechanism* const&) {} // there is only one

private:
  static constexpr int none = mechanics::none;

  constexpr bool has_room(int count, int most) {
    if (count == most) into_.is_full = true;
    return count < most;
  }

  constexpr void write(int integer) {
    if (has_room(into_.integers, image::most_integers)) into_.integer[into_.integers++] = integer;
  }

  constexpr void write_nodes(const symbolic::graph& g) {
    if (g.size() > image::most_nodes) {
      into_.is_full = true;
      return;
    }
    into_.nodes = g.size();
    int id = 0;
    for (const symbolic::node& n : g) {
      into_.op[id] = n.op;
      into_.a[id] = n.a;
      into_.b[id++] = n.b;
    }
  }

  constexpr void write_numbers(const symbolic::graph& g) {
    for (const symbolic::number& n : g.numbers()) {
      if (!has_room(into_.numbers, image::most_numbers)) return;
      into_.numerators[into_.numbers] = n.numerator;
      into_.denominators[into_.numbers] = n.denominator;
      into_.reals[into_.numbers++] = n.real;
    }
  }

  constexpr void write_externals(const symbolic::graph& g) {
    for (const symbolic::external_function* f : g.externals())
      if (has_room(into_.externals, image::most_externals)) into_.external[into_.externals++] = f;
  }

  image& into_;
};

constexpr image_writer::image_writer(image& into, const symbolic::graph& g) : into_(into) {
  write_nodes(g);
  write_numbers(g);
  write_externals(g);
  (*this)(g.symbols());
}

} // namespace kanexpr::derivation
