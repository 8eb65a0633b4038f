#pragma once

#include <kanexpr/derivation/model_error.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <Eigen/Core>

namespace kanexpr {

namespace compiled {

/// A system's survey, formed once, with the end of the compilation if it holds a mistake.
template <class System>
struct surveyed {
  using system = System;
  static constexpr derivation::survey survey = derivation::survey_of<System>();
  static constexpr mechanics::problem mistake = survey.mistake;
  static constexpr bool follows_from_unparsed = survey.follows_from_unparsed;
  static_assert(derivation::tell<surveyed>());
};

template <class System>
inline constexpr const derivation::survey& survey_of = surveyed<System>::survey;

template <class System, symbolic::symbol_kind kind, text called, int index,
          int order = describe::unprescribed>
struct placed {
  static constexpr const describe::symbol_record& symbol =
      describe::symbol_storage<kind, called, index, order>::record;
  static constexpr int found = survey_of<System>.place(kind, symbol.called);
  static constexpr int place = found >= 0 ? found : 0;
  static constexpr mechanics::problem mistake = [] {
    if (found >= 0 || survey_of<System>.mistake) return mechanics::problem{};
    if (kind == symbolic::symbol_kind::coordinate_rate)
      return mechanics::sentence(
          {"the state of ", type_name<System>(), " holds no rate of coordinate ", symbol.called.view()});
    const std::string_view what = derivation::kind_of(symbol);
    return mechanics::sentence({"the system ", type_name<System>(), " has no ", what, symbol.called.view()});
  }();
  static_assert(derivation::tell<placed>());
};

/// A symbol of a kind that a vector does not hold, such as a parameter asked of the state.
template <class System, class Symbol, text vector>
struct misplaced {
  static constexpr Symbol asked{};
  static constexpr mechanics::problem mistake = [] {
    if (survey_of<System>.mistake) return mechanics::problem{};
    const describe::symbol_record* s = asked.tokens[0].symbol;
    return mechanics::sentence({s != nullptr ? s->called.view() : "the expression", " has no place in the ",
                                vector.view(), " of ", type_name<System>()});
  }();
  static_assert(derivation::tell<misplaced>());
  static constexpr int place = 0;
};

} // namespace compiled

/// The state [q; u] of a system, by Lagrange's method [q; dq/dt]: a fixed-size Eigen vector with access by
/// name, `x[q1]`.
template <class System, class Scalar = double>
class state
    : public Eigen::Matrix<Scalar,
                           compiled::survey_of<System>.coordinates + compiled::survey_of<System>.speeds, 1> {
public:
  static constexpr int coordinates = compiled::survey_of<System>.coordinates;
  static constexpr int speeds = compiled::survey_of<System>.speeds;
  using base = Eigen::Matrix<Scalar, coordinates + speeds, 1>;
  using base::base;
  using base::operator=;
  using base::operator[];

  state() {
    derivation::tell_in_code<compiled::surveyed<System>>();
    this->setConstant(lower::scalar_math<Scalar>::from(0));
  }

  template <text called, int index>
  Scalar& operator[](const coordinate<called, index>&) {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::coordinate, called, index>::place);
  }
  template <text called, int index>
  const Scalar& operator[](const coordinate<called, index>&) const {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::coordinate, called, index>::place);
  }
  template <text called, int index>
  Scalar& operator[](const speed<called, index>&) {
    return (*this)(coordinates +
                   compiled::placed<System, symbolic::symbol_kind::speed, called, index>::place);
  }
  template <text called, int index>
  const Scalar& operator[](const speed<called, index>&) const {
    return (*this)(coordinates +
                   compiled::placed<System, symbolic::symbol_kind::speed, called, index>::place);
  }
  /// By Lagrange's method the rates of the coordinates are in the state: `x[dot(q1)]`.
  template <text called, int index>
  Scalar& operator[](const coordinate_rate<called, index>&) {
    return (*this)(coordinates +
                   compiled::placed<System, symbolic::symbol_kind::coordinate_rate, called, index>::place);
  }
  template <text called, int index>
  const Scalar& operator[](const coordinate_rate<called, index>&) const {
    return (*this)(coordinates +
                   compiled::placed<System, symbolic::symbol_kind::coordinate_rate, called, index>::place);
  }

  template <describe::expression_of_a_model Symbol>
  Scalar& operator[](const Symbol&) {
    return (*this)(compiled::misplaced<System, Symbol, "state vector">::place);
  }
  template <describe::expression_of_a_model Symbol>
  const Scalar& operator[](const Symbol&) const {
    return (*this)(compiled::misplaced<System, Symbol, "state vector">::place);
  }

  auto q() { return this->template head<coordinates>(); }
  auto q() const { return this->template head<coordinates>(); }
  auto u() { return this->template tail<speeds>(); }
  auto u() const { return this->template tail<speeds>(); }
};

/// The parameters of a system that are not bound in its type, with access by name, `p[m]`.
template <class System, class Scalar = double>
class parameter_values : public Eigen::Matrix<Scalar, compiled::survey_of<System>.parameters, 1> {
public:
  using base = Eigen::Matrix<Scalar, compiled::survey_of<System>.parameters, 1>;
  using base::base;
  using base::operator=;
  using base::operator[];

  parameter_values() { this->setConstant(lower::scalar_math<Scalar>::from(0)); }

  template <text called, int index>
  Scalar& operator[](const parameter<called, index>&) {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::parameter, called, index>::place);
  }
  template <text called, int index>
  const Scalar& operator[](const parameter<called, index>&) const {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::parameter, called, index>::place);
  }
  template <describe::expression_of_a_model Symbol>
  Scalar& operator[](const Symbol&) {
    return (*this)(compiled::misplaced<System, Symbol, "parameter vector">::place);
  }
  template <describe::expression_of_a_model Symbol>
  const Scalar& operator[](const Symbol&) const {
    return (*this)(compiled::misplaced<System, Symbol, "parameter vector">::place);
  }
};

/// The inputs of a system, with access by name, `r[T1]`.
template <class System, class Scalar = double>
class input_values : public Eigen::Matrix<Scalar, compiled::survey_of<System>.inputs, 1> {
public:
  using base = Eigen::Matrix<Scalar, compiled::survey_of<System>.inputs, 1>;
  using base::base;
  using base::operator=;
  using base::operator[];

  input_values() { this->setConstant(lower::scalar_math<Scalar>::from(0)); }

  template <text called, int index>
  Scalar& operator[](const input<called, index>&) {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::input, called, index>::place);
  }
  template <text called, int index>
  const Scalar& operator[](const input<called, index>&) const {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::input, called, index>::place);
  }
  /// Of a prescribed quantity or its derivatives: `r[theta]`, `r[dot(theta)]`.
  template <text called, int index, int order>
  Scalar& operator[](const prescribed<called, index, order>&) {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::input, called, index, order>::place);
  }
  template <text called, int index, int order>
  const Scalar& operator[](const prescribed<called, index, order>&) const {
    return (*this)(compiled::placed<System, symbolic::symbol_kind::input, called, index, order>::place);
  }
  template <describe::expression_of_a_model Symbol>
  Scalar& operator[](const Symbol&) {
    return (*this)(compiled::misplaced<System, Symbol, "input vector">::place);
  }
  template <describe::expression_of_a_model Symbol>
  const Scalar& operator[](const Symbol&) const {
    return (*this)(compiled::misplaced<System, Symbol, "input vector">::place);
  }
};

} // namespace kanexpr
