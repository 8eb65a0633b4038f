#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/lower/regular.hpp>
#include <kanexpr/mechanics/dynamics/singular.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/linear/solve.hpp>

#include <Eigen/Core>

#include <limits>

namespace kanexpr::runtime {

/// A result that is interpreted, called like the compiled one: f(x), f(x, p), f(x, p, r), f(t, x, p, r) or
/// f(t, x, p, r, a). It keeps the matrix that it returns, and takes no memory when it is called.
template <class Scalar = double>
class interpreted {
public:
  using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// `guards`: what may be singular on the way to the results.
  interpreted(symbolic::graph& g, const symbolic::matrix& wanted, int coordinates,
              const symbolic::sequence<mechanics::guard>& guards = {})
      : code_(lower::tape_of(g, nodes(wanted, guards))), coordinates_(coordinates),
        result_(wanted.rows, wanted.columns), found_(code_.size()) {
    for (const mechanics::guard& each : guards) {
      causes_.push(each.cause);
      is_of_finiteness_.push(each.of_finiteness);
    }
  }

  /// Operations of one call.
  symbolic::cost cost() const { return lower::cost_of(code_.code()); }

  /// Whether all that the last call had to solve could be solved at its state.
  kanexpr::status status() const {
    for (int i = 0; i < causes_.size(); ++i) {
      const Scalar &measure = found_[result_.size() + 2 * i], &scale = found_[result_.size() + 2 * i + 1];
      constexpr double least = mechanics::least_regularity<Scalar>();
      if (is_of_finiteness_[i] ? !lower::passes<true>(measure, scale, least)
                               : !lower::passes<false>(measure, scale, least))
        return kanexpr::status(causes_[i].view());
    }
    return {};
  }

  template <class X>
  const matrix& operator()(const X& x) {
    return (*this)(Scalar(0), x, nothing{}, nothing{}, nothing{});
  }
  template <class X, class P>
  const matrix& operator()(const Eigen::MatrixBase<X>& x, const P& p) {
    return (*this)(Scalar(0), x.derived(), p, nothing{}, nothing{});
  }
  template <class X, class P, class R>
  const matrix& operator()(const Eigen::MatrixBase<X>& x, const P& p, const R& r) {
    return (*this)(Scalar(0), x.derived(), p, r, nothing{});
  }
  template <class X, class P, class R>
  const matrix& operator()(Scalar t, const X& x, const P& p, const R& r) {
    return (*this)(t, x, p, r, nothing{});
  }
  template <class X, class P, class R, class A>
  const matrix& operator()(Scalar t, const X& x, const P& p, const R& r, const A& a) {
    using symbolic::symbol_kind;
    code_.evaluate(
        [&](const lower::load& l) -> Scalar {
          switch (l.from) {
          case symbol_kind::coordinate: return Scalar(x[l.position]);
          case symbol_kind::speed: return Scalar(x[coordinates_ + l.position]);
          case symbol_kind::parameter: return Scalar(p[l.position]);
          case symbol_kind::input: return Scalar(r[l.position]);
          case symbol_kind::speed_rate: return Scalar(a[l.position]);
          case symbol_kind::time: return t;
          case symbol_kind::coordinate_rate:
          case symbol_kind::auxiliary_speed:
          case symbol_kind::multiplier: break; // are in no code
          }
          return t;
        },
        found_.data());
    result_ = Eigen::Map<const matrix>(found_.data(), result_.rows(), result_.cols());
    return result_;
  }

private:
  /// Stands for arguments that are not given; whoever needs one of them gets not-a-number.
  struct nothing {
    Scalar operator[](Eigen::Index) const { return std::numeric_limits<Scalar>::quiet_NaN(); }
  };

  static symbolic::sequence<int> nodes(const symbolic::matrix& wanted,
                                       const symbolic::sequence<mechanics::guard>& guards) {
    symbolic::sequence<int> ids;
    for (const symbolic::expression& e : wanted.entries) ids.push(e.node());
    for (const mechanics::guard& each : guards) {
      ids.push(each.measure.node());
      ids.push(each.scale.node());
    }
    return ids;
  }

  interpreter<Scalar> code_;
  int coordinates_;
  matrix result_;
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> found_; ///< the result, then how regular what it depends on is
  symbolic::sequence<mechanics::problem> causes_{};
  symbolic::sequence<bool> is_of_finiteness_{}; ///< each of them
};

} // namespace kanexpr::runtime
