#pragma once

#include <kanexpr/animate/elements.hpp>
#include <kanexpr/base/mesh_kind.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// Checks for mistakes in a shape.
namespace kanexpr::animate {

using base::sentence;
using describe::point_record;

template <class Element>
concept picture_element = requires { Element::word; };
template <class Element>
concept shape_element = picture_element<Element> && requires { typename Element::attachment; };

template <shape_element Element>
constexpr std::string_view kind_of() {
  if constexpr (requires { Element::attachment::shape; })
    return Element::attachment::shape;
  else
    return Element::word;
}

/// The title of a shape, such as "sphere at P" or "rod from O to P".
template <class Element>
constexpr base::name title_of() {
  base::name title;
  if constexpr (shape_element<Element>) {
    constexpr auto& points = Element::attachment::points;
    constexpr std::size_t count = std::size(points);
    title.append(kind_of<Element>());
    if constexpr (requires { Element::attachment::called; }) {
      title.append(" ");
      title.append(Element::attachment::called);
    } else if constexpr (count > 0) {
      title.append(count > 1 ? " from " : " at ");
      title.append(points[0]->called);
    }
    if constexpr (count > 1 && !requires { Element::attachment::called; }) {
      title.append(" to ");
      title.append(points[count - 1]->called);
    }
  } else {
    title.append(Element::word);
  }
  return title;
}

/// Checks that a size is a scalar that depends only on parameters.
constexpr sentence check_size(const phrase& given, std::string_view size, std::string_view whom) {
  if (given.kind != shape::scalar)
    return sentence({"the ", size, " of the ", whom, derivation::is_a(given.kind), "it must be a scalar"});
  for (int i = 0; i < given.size; ++i) {
    const describe::token& t = given.tokens[i];
    std::string_view kind, name;
    if (t.symbol != nullptr && t.symbol->kind != symbolic::symbol_kind::parameter) {
      kind = derivation::kind_of(*t.symbol);
      name = t.symbol->called.view();
    } else if (t.point != nullptr) {
      kind = "point ";
      name = t.point->called;
    } else if (t.frame != nullptr) {
      kind = "frame ";
      name = t.frame->called;
    }
    if (!kind.empty())
      return sentence({"the ", size, " of the ", whom, " contains the ", kind, name,
                       "; it may depend only on parameters"});
  }
  return {};
}

constexpr sentence check_vector(const phrase& given, std::string_view what, std::string_view whom) {
  if (given.kind == shape::vector) return {};
  return sentence({what, whom, derivation::is_a(given.kind), "it must be a vector"});
}

constexpr bool is_colour(std::string_view given) {
  if (given.size() != 7 || given[0] != '#') return false;
  for (char c : given.substr(1))
    if (!((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'))) return false;
  return true;
}

constexpr sentence check_look(const look& l, std::string_view whom) {
  if (!l.colour.empty() && !is_colour(l.colour))
    return sentence({"the colour of the ", whom, ", ", l.colour, ", is not of the form #1f5fa8"});
  if (!(numeric::is_finite(l.opacity) && l.opacity > 0 && l.opacity <= 1))
    return sentence({"the opacity of the ", whom, " must be above 0 and at most 1"});
  return {};
}

/// Checks only the name of the file; the file is read when a page is written.
constexpr sentence check_file(std::string_view file, std::string_view whom) {
  if (file.empty()) return sentence({"the ", whom, " has no file name"});
  if (mesh_kind_of(file).empty())
    return sentence({"the file of the ", whom, ", ", file, ", is not of the type .stl, .dae or .obj"});
  return {};
}

constexpr sentence check_mesh(std::string_view file, std::size_t scales, std::string_view whom) {
  if (scales == 2 || scales > 3)
    return sentence({"the ", whom, " has ", scales == 2 ? "two scales" : "more than three scales",
                     "; it takes one, or one along each axis"});
  return check_file(file, whom);
}

template <std::size_t size, class Names>
constexpr sentence check_sizes(const phrases<size>& sizes, const Names& names, std::string_view whom) {
  sentence found;
  for (std::size_t i = 0; i < size; ++i)
    if (!found) found = check_size(sizes[i], names[i], whom);
  return found;
}

/// Returns the name of a type without its template arguments.
template <class Type>
constexpr std::string_view template_name() {
  return type_name<Type>().substr(0, type_name<Type>().find('<'));
}

/// The mistake in something shown that is not a shape.
template <class Shape>
struct misused_as_shape {
  static constexpr sentence mistake() {
    return sentence({"the picture shows ", template_name<Shape>(), ", which is not a shape"});
  }
};

template <class Option, class Shape>
constexpr sentence check_option(std::string_view whom) {
  if constexpr (!option_of_shape<Option>)
    return sentence(
        {"the ", whom, " is shown with ", template_name<Option>(), ", which is not an option of a shape"});
  if constexpr (requires { Option::spin; }) {
    if constexpr (!requires { Shape::axis; }) return sentence({"the ", whom, " is spinning but has no axis"});
    if (Option::spin.kind != shape::scalar)
      return sentence({"the spin of the ", whom, derivation::is_a(Option::spin.kind), "it must be a scalar"});
  }
  return {};
}

template <class Shape, class... Options>
constexpr sentence check_options(std::string_view whom) {
  sentence found;
  int spins = 0;
  ((found = found ? found : check_option<Options, Shape>(whom)), ...);
  ((spins += requires { Options::spin; } ? 1 : 0), ...);
  if (!found && spins > 1) found = sentence({"the ", whom, " has more than one spinning<...>"});
  return found;
}

} // namespace kanexpr::animate
