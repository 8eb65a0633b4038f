#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/describe/symbol.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

/// The index of a symbol of a model in a vector of values.
namespace kanexpr::compiled {

template <class System, symbolic::symbol_kind kind, text called, int index,
          int order = describe::unprescribed>
struct placed {
  static constexpr const describe::symbol_record& symbol =
      describe::symbol_storage<kind, called, index, order>::record;
  static constexpr int found = survey_of<System>.place(kind, symbol.called);
  static constexpr int place = found >= 0 ? found : 0;
  static constexpr base::sentence mistake = [] {
    if (found >= 0 || survey_of<System>.mistake) return base::sentence{};
    if (kind == symbolic::symbol_kind::coordinate_rate)
      return base::sentence({"the state of ", type_name<System>(),
                             " does not contain the rate of coordinate ", symbol.called.view()});
    const std::string_view what = derivation::kind_of(symbol);
    return base::sentence({"the system ", type_name<System>(), " has no ", what, symbol.called.view()});
  }();
  static_assert(derivation::report<placed>());
};

/// A symbol of a kind that a vector does not contain, such as a parameter looked up in the state.
template <class System, class Symbol, text vector>
struct misplaced {
  static constexpr Symbol asked{};
  static constexpr base::sentence mistake = [] {
    if (survey_of<System>.mistake) return base::sentence{};
    const describe::symbol_record* s = asked.tokens[0].symbol;
    return base::sentence({s != nullptr ? s->called.view() : "the expression", " is not an entry of the ",
                           vector.view(), " of ", type_name<System>()});
  }();
  static_assert(derivation::report<misplaced>());
  static constexpr int place = 0;
};

template <symbols_of which>
inline constexpr text vector_name = "state vector";
template <>
inline constexpr text vector_name<symbols_of::parameters> = "parameter vector";
template <>
inline constexpr text vector_name<symbols_of::inputs> = "input vector";

/// The index of a symbol in a vector of a system. A symbol that the vector does not contain causes a
/// compile-time error.
template <class System, symbols_of which, class Symbol>
struct place_in : misplaced<System, Symbol, vector_name<which>> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::state, coordinate<called, index>>
    : placed<System, symbolic::symbol_kind::coordinate, called, index> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::state, speed<called, index>> {
  static constexpr int place =
      survey_of<System>.coordinates + placed<System, symbolic::symbol_kind::speed, called, index>::place;
};

/// With Lagrange's method, the rates of the coordinates are in the state: `x[dot(q1)]`.
template <class System, text called, int index>
struct place_in<System, symbols_of::state, coordinate_rate<called, index>> {
  static constexpr int place = survey_of<System>.coordinates +
                               placed<System, symbolic::symbol_kind::coordinate_rate, called, index>::place;
};

template <class System, text called, int index>
struct place_in<System, symbols_of::parameters, parameter<called, index>>
    : placed<System, symbolic::symbol_kind::parameter, called, index> {};

template <class System, text called, int index>
struct place_in<System, symbols_of::inputs, input<called, index>>
    : placed<System, symbolic::symbol_kind::input, called, index> {};

/// The index of a prescribed quantity or of its derivatives: `r[theta]`, `r[dot(theta)]`.
template <class System, text called, int index, int order>
struct place_in<System, symbols_of::inputs, prescribed<called, index, order>>
    : placed<System, symbolic::symbol_kind::input, called, index, order> {};

} // namespace kanexpr::compiled
