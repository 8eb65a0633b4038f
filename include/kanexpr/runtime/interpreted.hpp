#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>

#include <limits>
#include <string_view>

namespace kanexpr::runtime {

/// An interpreted result, called like the compiled one: f(x), f(x, p), f(x, p, r), f(t, x, p, r) or f(t, x,
/// p, r, a). After the inputs come the other arguments that the result reads, in this order: the rates of the
/// speeds, weights, a direction. The object owns the matrix that it returns, and a call does not allocate
/// memory. If a vector is omitted or too short, or the model has a mistake, the entries are NaN and the
/// status reports the cause.
template <class Scalar = double>
class interpreted {
  /// An omitted argument.
  struct omitted {
    static constexpr Eigen::Index size() { return 0; }
    Scalar operator[](Eigen::Index) const { return not_a_number(); }
  };

public:
  using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// `checks` detect singularities in the computation of the result. If the result has no values at any
  /// state, `mistake` is the reason. If it must be finite, the status reports every entry that is not.
  interpreted(symbolic::graph& g, const symbolic::matrix& wanted, int coordinates,
              const base::sequence<mechanics::singularity_check>& checks = {},
              const base::sentence& mistake = {}, bool must_be_finite = false)
      : code_(g, wanted, checks, must_be_finite), coordinates_(coordinates), mistake_(mistake),
        result_(wanted.rows, wanted.columns) {
    for (const lower::load& each : code_.code().loads)
      if (need* const of = need_of(each.from)) of->take(place_of(each), g, each);
  }

  /// The number of operations per call.
  symbolic::cost cost() const { return code_.cost(); }

  /// Reports whether all systems of equations could be solved at the state of the last call.
  kanexpr::status status() const {
    if (mistake_) return kanexpr::status(mistake_.view());
    return too_short_ ? kanexpr::status(too_short_.view()) : code_.status();
  }

  template <class State>
  const matrix& operator()(const State& x) {
    return (*this)(Scalar(0), x, omitted{}, omitted{});
  }
  template <class State, class Parameters>
  const matrix& operator()(const Eigen::MatrixBase<State>& x, const Parameters& p) {
    return (*this)(Scalar(0), x.derived(), p, omitted{});
  }
  template <class State, class Parameters, class Inputs>
  const matrix& operator()(const Eigen::MatrixBase<State>& x, const Parameters& p, const Inputs& r) {
    return (*this)(Scalar(0), x.derived(), p, r);
  }
  template <class State, class Parameters, class Inputs, class First = omitted, class Second = omitted,
            class Third = omitted>
  const matrix& operator()(Scalar t, const State& x, const Parameters& p, const Inputs& r,
                           const First& a = {}, const Second& b = {}, const Third& c = {}) {
    using symbolic::symbol_kind;
    too_short_ = {};
    check_length(state_, x), check_length(parameters_, p), check_length(inputs_, r);
    const int weights = rates_.entries > 0 ? 1 : 0, direction = weights + (weights_.entries > 0 ? 1 : 0);
    const auto behind = [&](int place, const auto& take) {
      place == 0 ? take(a) : place == 1 ? take(b) : take(c);
    };
    behind(0, [&](const auto& given) { check_length(rates_, given); });
    behind(weights, [&](const auto& given) { check_length(weights_, given); });
    behind(direction, [&](const auto& given) { check_length(direction_, given); });
    if (mistake_ || too_short_) {
      result_.setConstant(not_a_number());
      return result_;
    }
    const Scalar* const found = code_.evaluate([&](const lower::load& each) -> Scalar {
      switch (each.from) {
      case symbol_kind::coordinate:
      case symbol_kind::speed: return Scalar(x[place_of(each)]);
      case symbol_kind::parameter: return Scalar(p[each.position]);
      case symbol_kind::input: return Scalar(r[each.position]);
      case symbol_kind::speed_rate: return Scalar(a[each.position]);
      case symbol_kind::weight: return weights == 0 ? Scalar(a[each.position]) : Scalar(b[each.position]);
      case symbol_kind::direction:
        return direction == 0   ? Scalar(a[each.position])
               : direction == 1 ? Scalar(b[each.position])
                                : Scalar(c[each.position]);
      case symbol_kind::time: return t;
      case symbol_kind::coordinate_rate:
      case symbol_kind::auxiliary_speed:
      case symbol_kind::multiplier: break; // does not occur in code
      }
      return t;
    });
    result_ = Eigen::Map<const matrix>(found, result_.rows(), result_.cols());
    return result_;
  }

private:
  static Scalar not_a_number() {
    return lower::scalar_math<Scalar>::from(std::numeric_limits<double>::quiet_NaN());
  }

  /// The last entry of a vector that the code reads.
  struct need {
    std::string_view vector;
    int entries = 0;
    base::name last{};

    void take(int place, const symbolic::graph& g, const lower::load& read) {
      if (place < entries) return;
      entries = place + 1;
      for (const symbolic::symbol& s : g.symbols())
        if (s.kind == read.from && s.position == read.position) last = s.called;
    }
  };

  need* need_of(symbolic::symbol_kind kind) {
    using symbolic::symbol_kind;
    switch (kind) {
    case symbol_kind::coordinate:
    case symbol_kind::speed: return &state_;
    case symbol_kind::parameter: return &parameters_;
    case symbol_kind::input: return &inputs_;
    case symbol_kind::speed_rate: return &rates_;
    case symbol_kind::weight: return &weights_;
    case symbol_kind::direction: return &direction_;
    case symbol_kind::time:
    case symbol_kind::coordinate_rate:
    case symbol_kind::auxiliary_speed:
    case symbol_kind::multiplier: break;
    }
    return nullptr;
  }
  int place_of(const lower::load& read) const {
    return read.from == symbolic::symbol_kind::speed ? coordinates_ + read.position : read.position;
  }

  template <class Vector>
  void check_length(const need& of, const Vector& given) {
    if constexpr (requires { given.size(); }) {
      const int size = static_cast<int>(given.size());
      if (too_short_ || size >= of.entries) return;
      too_short_ = base::sentence({"the ", of.vector, " vector has ", base::counted(size).view(),
                                   size == 1 ? " entry" : " entries", ", but none for ", of.last.view()});
    }
  }

  checked_code<Scalar> code_;
  int coordinates_;
  base::sentence mistake_;
  need state_{"state"}, parameters_{"parameter"}, inputs_{"input"}, rates_{"acceleration"},
      weights_{"weight"}, direction_{"direction"};
  base::sentence too_short_{};
  matrix result_;
};

} // namespace kanexpr::runtime
