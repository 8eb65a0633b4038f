#pragma once

#include <kanexpr/animate/check_shape.hpp>
#include <kanexpr/animate/check_sweep.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks for mistakes in a picture.
namespace kanexpr::animate {

/// Checks that a unit is given for coordinates, speeds and inputs.
template <std::size_t size>
constexpr sentence check_symbols(const phrases<size>& symbols, std::string_view unit) {
  using symbolic::symbol_kind;
  constexpr std::string_view hint = "; it may be given only for coordinates, speeds and inputs";
  for (const phrase& p : symbols) {
    const describe::symbol_record* symbol = p.size == 1 ? p.tokens[0].symbol : nullptr;
    if (symbol == nullptr) return sentence({"the unit ", unit, " is given for an expression", hint});
    if (symbol->kind == symbol_kind::parameter || symbol->kind == symbol_kind::time)
      return sentence({"the unit ", unit, " is given for the ", derivation::kind_of(*symbol),
                       symbol->called.view(), hint});
  }
  return {};
}

constexpr sentence check_plot(const phrase& given, std::string_view name) {
  if (name.empty()) return sentence({"a plot has no name"});
  if (given.kind == shape::scalar) return {};
  return sentence({"the plot of ", name, derivation::is_a(given.kind), "it must be a scalar"});
}

template <class Element>
struct check_element {
  static constexpr sentence mistake() {
    if constexpr (requires { Element::shape; }) {
      return sentence(
          {Element::shape, "<...> is a shape, not an element of the picture; wrap it in show<...>"});
    } else if constexpr (!picture_element<Element>) {
      return sentence({template_name<Element>(), " is not an element of a picture"});
    } else {
      if constexpr (requires { Element::size_names; })
        return check_sizes(Element::constant, Element::size_names, Element::word);
      if constexpr (requires { Element::vector_name; })
        return check_vector(Element::constant[0], "the direction of ", Element::word);
      if constexpr (requires { Element::symbols; }) return check_symbols(Element::symbols, Element::unit);
      if constexpr (Element::word == "plot") return check_plot(Element::varying[0], Element::name);
      return {};
    }
  }
};

template <class Shape, class... Options>
struct check_element<show<Shape, Options...>> {
  static constexpr sentence mistake() {
    using shown = show<Shape, Options...>;
    if constexpr (!shape_element<shown>) {
      return misused_as_shape<Shape>::mistake();
    } else {
      constexpr base::name whom = title_of<shown>();
      sentence found;
      if constexpr (requires { Shape::places; }) found = check_curve<Shape>(whom.view());
      if constexpr (requires { Shape::file; })
        found = check_mesh(Shape::file, Shape::scale_count, whom.view());
      if constexpr (requires { Shape::size_names; })
        if (!found) found = check_sizes(Shape::sizes, Shape::size_names, whom.view());
      if constexpr (requires { Shape::vector; })
        if (!found) found = check_vector(Shape::vector, "the vector of the ", whom.view());
      if constexpr (requires { Shape::axis; })
        if (!found) found = check_vector(Shape::axis, "the axis of the ", whom.view());
      if (!found) found = check_options<Shape, Options...>(whom.view());
      return found ? found : check_look(shown::look, whom.view());
    }
  }
};

template <class Point, class... Options>
struct check_element<trace<Point, Options...>> {
  static constexpr sentence mistake() {
    using traced = trace<Point, Options...>;
    constexpr base::name whom = title_of<traced>();
    const sentence found = check_options<at<Point>, Options...>(whom.view());
    return found ? found : check_look(traced::look, whom.view());
  }
};

constexpr const point_record* origin_under(const point_record* p) {
  for (int steps = 0; p->parent != nullptr && steps < 10000; ++steps) p = p->parent;
  return p;
}

/// Checks that all positions are measured from the same origin.
struct origin_check {
  const point_record* first = nullptr;
  sentence mistake{};

  template <class Element>
  constexpr void check_origins() {
    if constexpr (shape_element<Element>)
      for (const point_record* p : Element::attachment::points) compare(p);
    else if constexpr (requires { Element::points; })
      for (const point_record* p : Element::points) compare(p);
  }

private:
  constexpr void compare(const point_record* p) {
    if (first == nullptr) first = p;
    const point_record *here = origin_under(p), *there = origin_under(first);
    if (here->origin_of == nullptr || there->origin_of == nullptr)
      return; // not points: reported when the model is read
    if (here != there && !mistake)
      mistake =
          sentence({"point ", p->called, " is attached to the origin ", here->called, ", but ", first->called,
                    " to the origin ", there->called, "; the displacement between them is unknown"});
  }
};

template <class Element>
constexpr bool has_keyword(std::string_view word) {
  if constexpr (picture_element<Element>)
    return Element::word == word;
  else
    return false;
}

template <class... Elements>
constexpr sentence check_elements() {
  sentence found;
  ((found = found ? found : check_element<Elements>::mistake()), ...);
  if (found) return found;
  const auto times = [](std::string_view word) { return ((has_keyword<Elements>(word) ? 1 : 0) + ... + 0); };
  if (times("show") + times("trace") == 0) return sentence({"the picture shows nothing"});
  if (times("up") == 0) return sentence({"the picture does not specify the up direction; add up<vector>"});
  for (std::string_view word : {"up", "seen_from", "ground", "carried", "files_in", "show_forces",
                                "show_velocities", "show_frames", "plot_energies"})
    if (times(word) > 1) return sentence({"the picture lists ", word, "<...> twice"});
  origin_check origins;
  (origins.check_origins<Elements>(), ...);
  return origins.mistake;
}

} // namespace kanexpr::animate
