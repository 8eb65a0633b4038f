#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/element.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <cstdint>
#include <optional>
#include <type_traits>

namespace kanexpr::derivation {

/// A stored derivation, as plain arrays that can outlive constant evaluation: the graph node by node, and
/// everything else known at that stage as a sequence of integers.
///
/// Its capacity suffices for any model that a compiler can derive in reasonable time; entries beyond the
/// counts are unused. Only constant evaluation may use it, because any other reference would put it into the
/// program.
struct image {
  static constexpr int most_nodes = symbolic::graph::most_constant / 2;
  static constexpr int most_integers = 1 << 18;
  static constexpr int most_numbers = 1 << 14;
  static constexpr int most_entities = 1 << 12;
  static constexpr int most_externals = 1 << 8;

  symbolic::graph::stored graph{};

  int numbers = 0;
  std::int64_t numerators[most_numbers]{};
  std::int64_t denominators[most_numbers]{};
  double reals[most_numbers]{};

  int integers = 0;
  int integer[most_integers]{};

  int frames = 0;
  const describe::frame_record* frame[most_entities]{};
  int points = 0;
  const describe::point_record* point[most_entities]{};

  int externals = 0;
  const symbolic::external_function* external[most_externals]{};

  int kinds = 0;
  const mechanics::element_kind* kind[most_entities]{};

  /// Whether a part was omitted because an array was full.
  bool is_full = false;
};

/// Separates the two parts in which an image stores an integer of 64 bits.
inline constexpr std::int64_t one_above_int = std::int64_t{1} << 31;

/// Writes a derivation into an image, or reads it from one: `transfer(part)` for each part, in the same
/// order. Nodes keep their indices.
///
/// Both directions share one function for each type of a part, because compilers take long to instantiate
/// these functions. Writing does not change the parts.
class image_transfer {
public:
  /// Writes; starts with the graph.
  constexpr image_transfer(image& into, const symbolic::graph& g);
  /// Reads; starts with the graph.
  constexpr image_transfer(const image& from, symbolic::graph& g, const mechanics::mechanism& m);

  template <class... Parts>
    requires(sizeof...(Parts) > 1)
  constexpr void operator()(Parts&... parts) {
    ((*this)(parts), ...);
  }
  template <class Part>
  constexpr void operator()(Part& part) {
    if constexpr (std::is_integral_v<Part> || std::is_enum_v<Part>)
      transfer(part);
    else
      for_each_member(part, *this);
  }
  template <class Part>
  constexpr void operator()(base::sequence<Part>& parts) {
    if (writes_)
      write(parts.size());
    else
      parts.clear(), parts.resize(read());
    for (Part& each : parts) (*this)(each);
  }
  template <class Part>
  constexpr void operator()(std::optional<Part>& part) {
    if (writes_)
      write(part.has_value());
    else if (read() != 0)
      part.emplace(*g_);
    if (part.has_value()) (*this)(*part);
  }
  constexpr void operator()(base::sequence<symbolic::expression>& all) { // most of the content
    if (writes_) return write(all);
    all.clear();
    all.resize(read());
    for (symbolic::expression& e : all) {
      const int node = from_->integer[next_integer_++];
      if (node != none) e = {*g_, node};
    }
  }
  constexpr void operator()(symbolic::expression& e) {
    if (writes_) return write(e.is_given() ? e.node() : none);
    const int node = from_->integer[next_integer_++];
    if (node != none) e = {*g_, node};
  }
  constexpr void operator()(mechanics::components& v) { // without a call for each member
    if (writes_) {
      if (into_->integers + 3 > image::most_integers) {
        into_->is_full = true;
        return;
      }
      auto& integer = into_->integer;
      const int first = into_->integers;
      integer[first] = v.x.is_given() ? v.x.node() : none;
      integer[first + 1] = v.y.is_given() ? v.y.node() : none;
      integer[first + 2] = v.z.is_given() ? v.z.node() : none;
      into_->integers = first + 3;
    } else {
      const auto& integer = from_->integer;
      const int x = integer[next_integer_], y = integer[next_integer_ + 1], z = integer[next_integer_ + 2];
      next_integer_ += 3;
      if (x != none) v.x = {*g_, x};
      if (y != none) v.y = {*g_, y};
      if (z != none) v.z = {*g_, z};
    }
  }
  constexpr void operator()(base::sequence<int>& all) {
    const int size = writes_ ? all.size() : read();
    if (!writes_) {
      all.clear();
      all.resize(size);
      int* const into = all.begin();
      const auto& integer = from_->integer;
      for (int i = 0; i < size; ++i) into[i] = integer[next_integer_ + i];
      next_integer_ += size;
      return;
    }
    write(size);
    if (into_->integers + size > image::most_integers) {
      into_->is_full = true;
      return;
    }
    const int* const from = all.begin();
    auto& integer = into_->integer;
    for (int i = 0; i < size; ++i) integer[into_->integers + i] = from[i];
    into_->integers += size;
  }
  constexpr void operator()(std::int64_t& part) { // in two parts
    if (writes_) {
      write(static_cast<int>(part % one_above_int)), write(static_cast<int>(part / one_above_int));
    } else {
      part = read();
      part += one_above_int * read();
    }
  }
  constexpr void operator()(base::name& called) {
    transfer(called.length);
    const int length = called.length;
    auto& letters = called.letters;
    if (!writes_) {
      const auto& integer = from_->integer;
      for (int i = 0; i < length; ++i) letters[i] = static_cast<char>(integer[next_integer_ + i]);
      next_integer_ += length;
    } else if (into_->integers + length > image::most_integers) {
      into_->is_full = true;
    } else {
      auto& integer = into_->integer;
      for (int i = 0; i < length; ++i) integer[into_->integers + i] = static_cast<unsigned char>(letters[i]);
      into_->integers += length;
    }
  }
  constexpr void operator()(const describe::frame_record*& r) {
    if (!writes_)
      r = from_->frame[next_frame_++];
    else if (has_room(into_->frames, image::most_entities))
      into_->frame[into_->frames++] = r;
  }
  constexpr void operator()(const describe::point_record*& r) {
    if (!writes_)
      r = from_->point[next_point_++];
    else if (has_room(into_->points, image::most_entities))
      into_->point[into_->points++] = r;
  }
  constexpr void operator()(const mechanics::element_kind*& kind) {
    if (!writes_)
      kind = from_->kind[next_kind_++];
    else if (has_room(into_->kinds, image::most_entities))
      into_->kind[into_->kinds++] = kind;
  }
  constexpr void operator()(const mechanics::mechanism*& m) { // there is only one
    if (!writes_) m = m_;
  }

private:
  static constexpr int none = mechanics::none;
  static constexpr int more_numbers = 32; ///< that a resumed derivation adds without growing the sequence

  template <class Integer>
  constexpr void transfer(Integer& part) {
    if (writes_)
      write(static_cast<int>(part));
    else
      part = static_cast<Integer>(read());
  }

  constexpr int read() { return from_->integer[next_integer_++]; }

  constexpr bool has_room(int count, int most) {
    if (count == most) into_->is_full = true;
    return count < most;
  }

  constexpr void write(int integer) {
    if (into_->integers == image::most_integers)
      into_->is_full = true;
    else
      into_->integer[into_->integers++] = integer;
  }
  constexpr void write(const base::sequence<symbolic::expression>& all) {
    write(all.size());
    if (into_->integers + all.size() > image::most_integers) {
      into_->is_full = true;
      return;
    }
    int* next = into_->integer + into_->integers;
    for (const symbolic::expression& e : all) *next++ = e.is_given() ? e.node() : none;
    into_->integers += all.size();
  }

  constexpr void write_numbers(const symbolic::graph& g) {
    for (const symbolic::number& n : g.numbers()) {
      if (!has_room(into_->numbers, image::most_numbers)) return;
      into_->numerators[into_->numbers] = n.numerator;
      into_->denominators[into_->numbers] = n.denominator;
      into_->reals[into_->numbers++] = n.real;
    }
  }

  constexpr void write_externals(const symbolic::graph& g) {
    for (const symbolic::external_function* f : g.externals())
      if (has_room(into_->externals, image::most_externals)) into_->external[into_->externals++] = f;
  }

  bool writes_ = false;
  image* into_ = nullptr; ///< null if it reads
  const image* from_ = nullptr;
  symbolic::graph* g_ = nullptr;
  const mechanics::mechanism* m_ = nullptr;
  int next_integer_ = 0, next_frame_ = 0, next_point_ = 0, next_kind_ = 0;
};

constexpr image_transfer::image_transfer(image& into, const symbolic::graph& g)
    : writes_(true), into_(&into) {
  if (g.size() > image::most_nodes)
    into.is_full = true;
  else
    g.store(into.graph);
  write_numbers(g);
  write_externals(g);
  base::sequence<symbolic::symbol> symbols = g.symbols();
  (*this)(symbols);
}

constexpr image_transfer::image_transfer(const image& from, symbolic::graph& g, const mechanics::mechanism& m)
    : from_(&from), g_(&g), m_(&m) {
  base::sequence<symbolic::number> numbers;
  numbers.reserve(from.numbers + more_numbers);
  for (int i = 0; i < from.numbers; ++i)
    numbers.push({from.numerators[i], from.denominators[i], from.reals[i]});
  base::sequence<symbolic::symbol> symbols;
  (*this)(symbols);
  g.restore(static_cast<base::sequence<symbolic::number>&&>(numbers),
            static_cast<base::sequence<symbolic::symbol>&&>(symbols), from.graph);
  for (int i = 0; i < from.externals; ++i) g.externals().push(from.external[i]);
}

} // namespace kanexpr::derivation
