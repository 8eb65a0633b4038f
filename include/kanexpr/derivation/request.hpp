#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/checks/check_derivatives.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/derivatives/jacobian.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <initializer_list>
#include <span>
#include <string_view>

namespace kanexpr::derivation {

using mechanics::quantity;

/// The rows and columns of a result. A scalar is distinguished from a 1×1 matrix.
struct extent {
  int rows = 1;
  int columns = 1;
  bool scalar = false;

  constexpr int entries() const { return rows * columns; }
};

/// The symbols with respect to which results are differentiated.
enum class with_respect_to : unsigned char { state, inputs, rates };

/// A result requested from a system, as a value that is treated in the same way at compile time and at run
/// time.
struct request {
  enum class kind : unsigned char {
    foreign,     ///< not a valid request
    result,      ///< a quantity of the system
    expressions, ///< phrases of the model, one below the other; vectors as their components
    jacobian,    ///< the derivatives of a phrase with respect to symbols
    derivatives, ///< the derivatives of a quantity of the system with respect to symbols of the system
    sensitivity, ///< the sensitivity of phrases to the state or to the inputs
    parameters,  ///< the sensitivity of the rates of the state to parameters, given as phrases
  };

  kind what = kind::foreign;
  quantity wanted{};                       ///< the result, or the quantity to be differentiated
  with_respect_to symbols{};               ///< the symbols of derivatives
  bool is_at_given_rates = false;          ///< whether the result contains the symbols u̇
  std::span<const phrase> phrases{};       ///< the phrases of the other kinds
  std::string_view whom = "an expression"; ///< names the source of the phrases in messages
  std::span<const describe::token> by{};   ///< the symbols of a Jacobian
  bool is_to_inputs = false; ///< whether a sensitivity is with respect to the inputs, not the state

  /// Whether a function that returns it takes weights or a direction.
  constexpr bool is_weighted() const {
    return (what == kind::result || what == kind::derivatives) && mechanics::is_to_second_order(wanted);
  }

  /// Whether it is part of the linearized equations. Functions that return these report every entry that is
  /// not finite, even if only an argument can be the cause.
  constexpr bool is_of_linearization() const {
    return what == kind::sensitivity || (what == kind::result && mechanics::is_of_linearization(wanted));
  }
};

/// The arguments of a function that follow the inputs: rates of the speeds, weights, a direction.
struct extra_arguments {
  bool rates = false, weights = false, direction = false;
};

constexpr extra_arguments extra_arguments_of(std::initializer_list<const request*> all) {
  extra_arguments given;
  for (const request* each : all) {
    if (each->what != request::kind::result && each->what != request::kind::derivatives) continue;
    const mechanics::result_row& row = mechanics::row_of(each->wanted);
    given.rates = given.rates || row.holds_speed_rates || each->is_at_given_rates;
    given.weights = given.weights || row.takes_weights;
    given.direction = given.direction || row.takes_direction;
  }
  return given;
}

constexpr int rows_of(const phrase& p) { return p.kind == shape::vector ? 3 : 1; }

constexpr extent extent_of(const request& r, const survey& s) {
  int rows = 0;
  for (const phrase& p : r.phrases) rows += rows_of(p);
  switch (r.what) {
  case request::kind::foreign: break;
  case request::kind::result: {
    const mechanics::result_row& row = mechanics::row_of(r.wanted);
    return {s.count(row.rows), s.count(row.columns), row.rows == mechanics::extent_by::scalar};
  }
  case request::kind::derivatives: {
    const mechanics::result_row& row = mechanics::row_of(r.wanted);
    const int columns = r.symbols == with_respect_to::inputs  ? s.inputs
                        : r.symbols == with_respect_to::rates ? s.speeds
                                                              : s.coordinates + s.speeds;
    return {s.count(row.rows) * s.count(row.columns), columns};
  }
  case request::kind::expressions:
    return {rows, 1, r.phrases.size() == 1 && r.phrases[0].kind != shape::vector};
  case request::kind::jacobian: return {rows, static_cast<int>(r.by.size())};
  case request::kind::sensitivity: return {rows, r.is_to_inputs ? s.inputs : s.states()};
  case request::kind::parameters: return {s.coordinates + s.speeds, static_cast<int>(r.phrases.size())};
  }
  return {1, 1, true};
}

/// The stage of the derivation at which the request can be formed.
constexpr mechanics::stage stage_for(const request& r) {
  switch (r.what) {
  case request::kind::result:
  case request::kind::derivatives: return mechanics::row_of(r.wanted).needs;
  case request::kind::parameters: return mechanics::stage::equations;
  case request::kind::sensitivity: return mechanics::stage::linearized;
  case request::kind::foreign:
  case request::kind::expressions:
  case request::kind::jacobian: break;
  }
  return mechanics::stage::constrained;
}

/// Reads the entities that requests mention, before the results are formed.
constexpr void visit(std::span<const request> all, reader& r) {
  for (const request& wanted : all) {
    if (wanted.what == request::kind::foreign)
      r.fail("a function requests something that is not an expression of a model");
    for (const phrase& p : wanted.phrases) r.visit(p.tokens, p.size);
  }
  r.add_late_entities();
}

namespace detail {

/// A vector among the values of phrases, by the tokens of its phrase.
struct evaluated_vector {
  const describe::token* tokens = nullptr;
  int size = 0;
  int first_entry = 0;
};

/// Returns the index of the first component of a phrase that was evaluated before; -1 if it was not.
constexpr int first_entry_of(const phrase& p, const sequence<evaluated_vector>& vectors) {
  for (const evaluated_vector& each : vectors)
    if (each.size == p.size && each.tokens == p.tokens) return each.first_entry;
  return -1;
}

/// Returns the values of phrases, one below the other, with the symbols q̇ and u̇. A vector contributes its
/// components in inertial axes, or in the axes selected by in_axes_of. A picture requests most of its places
/// several times; the components of a repeated vector are copied.
constexpr symbolic::matrix values_of(const request& wanted, reader& r, const mechanism& m) {
  symbolic::matrix column(*m.g, 0, 1);
  sequence<evaluated_vector> vectors;
  for (const phrase& p : wanted.phrases) {
    if (const int first = first_entry_of(p, vectors); first >= 0) {
      for (int k = 0; k < 3; ++k) {
        const symbolic::expression same = column.entries[first + k];
        column.entries.push(same);
      }
      continue;
    }
    const value v = r.evaluate(p, wanted.whom);
    if (v.kind == shape::dyadic) {
      r.fail("a function requests a dyadic; it must request a scalar or a vector");
      return column;
    }
    if (p.kind != shape::vector || v.kind != shape::vector) {
      column.entries.push(v.scalar);
      continue;
    }
    const bool is_put_in_axes =
        p.tokens[p.size - 1].what == describe::token_kind::in_axes && v.vector.parts.size() == 1;
    const components c =
        is_put_in_axes ? v.vector.parts[0].value : mechanics::express(m, v.vector, mechanism::inertial);
    vectors.push({p.tokens, p.size, column.entries.size()});
    for (int k = 0; k < 3; ++k) column.entries.push(c[k]);
  }
  column.rows = column.entries.size();
  return column;
}

constexpr symbolic::matrix derivatives_of(const request& wanted, reader& r, const mechanism& m) {
  const symbolic::matrix values = values_of(wanted, r, m);
  symbolic::matrix by_symbols(*m.g, values.rows, static_cast<int>(wanted.by.size()));
  int column = 0;
  for (const describe::token& t : wanted.by) {
    const expression by = r.symbol(*t.symbol, wanted.whom);
    for (int i = 0; i < by_symbols.rows; ++i)
      by_symbols(i, column) = symbolic::differentiate(values.entries[i], by);
    ++column;
  }
  return by_symbols;
}

/// The derivatives of a result; q̇ and u̇ are replaced according to the equations of motion.
constexpr symbolic::matrix derivatives_of(const request& wanted, const mechanism& m,
                                          mechanics::equations& e) {
  const symbolic::matrix result = e.get(wanted.wanted);
  switch (wanted.symbols) {
  case with_respect_to::inputs: return symbolic::jacobian(*m.g, result.entries, m.inputs);
  case with_respect_to::rates: return symbolic::jacobian(*m.g, result.entries, m.speed_rates);
  case with_respect_to::state: break;
  }
  sequence<expression> state = m.coordinates;
  for (const expression& u : m.speeds) state.push(u);
  return symbolic::jacobian(*m.g, result.entries, state);
}

/// ∂[q̇; u̇]/∂p, one column per parameter.
constexpr symbolic::matrix sensitivity_to_parameters(const request& wanted, reader& r,
                                                     mechanics::equations& e) {
  sequence<expression> parameters;
  for (const phrase& p : wanted.phrases) {
    const bool is_symbol = p.size == 1 && p.tokens[0].what == describe::token_kind::symbol;
    sentence by({"a sensitivity is requested with respect to ",
                 is_symbol ? p.tokens[0].symbol->called.view() : "an expression"});
    if (!is_symbol || p.tokens[0].symbol->kind != symbolic::symbol_kind::parameter) {
      r.fail(sentence({by.view(), "; it must be a parameter"}).view());
      return {};
    }
    parameters.push(r.symbol(*p.tokens[0].symbol, wanted.whom));
    if (parameters[parameters.size() - 1].is_constant()) {
      r.fail(sentence({by.view(), ", which is bound to a number"}).view());
      return {};
    }
  }
  return e.sensitivity_to(parameters);
}

} // namespace detail

/// Forms the result of a visited request, with the symbols q̇ and u̇ if it contains them.
constexpr symbolic::matrix form_with_rates(const request& wanted, reader& r, mechanics::equations& e) {
  const mechanism& m = *e.skeleton_used().model;
  if (r.mistake()) return {};
  switch (wanted.what) {
  case request::kind::foreign: break;
  case request::kind::result:
    if (wanted.is_at_given_rates) return e.at_given_rates(wanted.wanted);
    return e.get(wanted.wanted);
  case request::kind::derivatives: return detail::derivatives_of(wanted, m, e);
  case request::kind::expressions: return detail::values_of(wanted, r, m);
  case request::kind::jacobian: return detail::derivatives_of(wanted, r, m);
  case request::kind::sensitivity: {
    const mechanics::explicit_linearization l =
        e.linearized().reduced().outputs(detail::values_of(wanted, r, m).entries);
    return wanted.is_to_inputs ? l.input : l.state;
  }
  case request::kind::parameters: return detail::sensitivity_to_parameters(wanted, r, e);
  }
  return {};
}

/// Forms the result with q̇ and u̇ replaced according to the equations.
constexpr symbolic::matrix form(const request& wanted, reader& r, mechanics::equations& e) {
  symbolic::matrix formed = form_with_rates(wanted, r, e);
  if (wanted.what != request::kind::result && wanted.what != request::kind::derivatives)
    formed = e.in_motion(formed);
  if (const sentence lacking = mechanics::check_derivatives(formed)) r.fail(lacking.view());
  return formed;
}

/// The request that corresponds to a template argument of a compiled function. The primary template is
/// invalid.
template <auto wanted, class Where = describe::file_of<wanted>>
struct requested {
  static constexpr request value{};
};

template <quantity wanted>
struct requested<wanted> {
  static constexpr request value{.what = request::kind::result, .wanted = wanted};
};

template <auto wanted>
  requires requires { describe::shape_of(wanted); }
struct requested<wanted> {
  static constexpr phrase words[]{describe::phrase_of<wanted>};
  static constexpr request value{.what = request::kind::expressions, .phrases = words};
};

template <int size, int columns, jacobian_matrix<size, columns> wanted>
struct requested<wanted> {
  static constexpr phrase words[]{{wanted.of_vector ? shape::vector : shape::scalar, wanted.tokens, size}};
  static constexpr request value{
      .what = request::kind::jacobian, .phrases = words, .whom = "a Jacobian", .by = wanted.by};
};

} // namespace kanexpr::derivation
