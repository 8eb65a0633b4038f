#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/image.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <optional>
#include <type_traits>

namespace kanexpr::derivation {

/// Reads a derivation from an image: `read(part)` for each part, in the order in which `image_writer` wrote
/// them. Nodes keep their indices.
class image_reader {
public:
  constexpr image_reader(const image& from, symbolic::graph& g, const mechanics::mechanism& m);

  template <class Part>
  constexpr void operator()(Part& part) {
    if constexpr (std::is_integral_v<Part> || std::is_enum_v<Part>)
      part = static_cast<Part>(read());
    else if constexpr (requires { Part::each_member(part, *this); })
      Part::each_member(part, *this);
    else
      for_each_member(part, *this);
  }
  template <class... Parts>
    requires(sizeof...(Parts) > 1)
  constexpr void operator()(Parts&... parts) {
    ((*this)(parts), ...);
  }
  template <class Part>
  constexpr void operator()(base::sequence<Part>& parts) {
    const int size = read();
    parts.clear();
    parts.resize(size);
    for (Part& each : parts) (*this)(each);
  }
  template <class Part>
  constexpr void operator()(std::optional<Part>& part) {
    if (read() == 0) return;
    part.emplace(g_);
    (*this)(*part);
  }
  constexpr void operator()(symbolic::expression& e) {
    const int node = read();
    if (node != mechanics::none) e = {g_, node};
  }
  constexpr void operator()(base::name& called) {
    called.length = read();
    for (int i = 0; i < called.length; ++i) called.letters[i] = static_cast<char>(read());
  }
  constexpr void operator()(const describe::frame_record*& r) { r = from_.frame[next_frame_++]; }
  constexpr void operator()(const describe::point_record*& r) { r = from_.point[next_point_++]; }
  constexpr void operator()(const mechanics::mechanism*& m) { m = &m_; }

private:
  constexpr int read() { return from_.integer[next_integer_++]; }

  const image& from_;
  symbolic::graph& g_;
  const mechanics::mechanism& m_;
  int next_integer_ = 0, next_frame_ = 0, next_point_ = 0;
};

constexpr image_reader::image_reader(const image& from, symbolic::graph& g, const mechanics::mechanism& m)
    : from_(from), g_(g), m_(m) {
  base::sequence<symbolic::number> numbers;
  numbers.reserve(from.numbers);
  for (int i = 0; i < from.numbers; ++i)
    numbers.push({from.numerators[i], from.denominators[i], from.reals[i]});
  base::sequence<symbolic::symbol> symbols;
  (*this)(symbols);
  g.restore(static_cast<base::sequence<symbolic::number>&&>(numbers),
            static_cast<base::sequence<symbolic::symbol>&&>(symbols), from.op, from.a, from.b, from.nodes);
  for (int i = 0; i < from.externals; ++i) g.externals().push(from.external[i]);
}

} // namespace kanexpr::derivation
