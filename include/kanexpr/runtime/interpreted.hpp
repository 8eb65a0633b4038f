#pragma once

#include <kanexpr/runtime/checked_code.hpp>

#include <Eigen/Core>

#include <limits>

namespace kanexpr::runtime {

/// A result that is interpreted, called like the compiled one: f(x), f(x, p), f(x, p, r), f(t, x, p, r) or
/// f(t, x, p, r, a). It keeps the matrix that it returns, and takes no memory when it is called.
template <class Scalar = double>
class interpreted {
public:
  using matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// `checks`: what may be singular on the way to the results.
  interpreted(symbolic::graph& g, const symbolic::matrix& wanted, int coordinates,
              const symbolic::sequence<mechanics::singularity_check>& checks = {})
      : code_(g, wanted, checks), coordinates_(coordinates), result_(wanted.rows, wanted.columns) {}

  /// Operations of one call.
  symbolic::cost cost() const { return code_.cost(); }

  /// Whether all that the last call had to solve could be solved at its state.
  kanexpr::status status() const { return code_.status(); }

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
    const Scalar* const found = code_.evaluate([&](const lower::load& each) -> Scalar {
      switch (each.from) {
      case symbol_kind::coordinate: return Scalar(x[each.position]);
      case symbol_kind::speed: return Scalar(x[coordinates_ + each.position]);
      case symbol_kind::parameter: return Scalar(p[each.position]);
      case symbol_kind::input: return Scalar(r[each.position]);
      case symbol_kind::speed_rate: return Scalar(a[each.position]);
      case symbol_kind::time: return t;
      case symbol_kind::coordinate_rate:
      case symbol_kind::auxiliary_speed:
      case symbol_kind::multiplier: break; // are in no code
      }
      return t;
    });
    result_ = Eigen::Map<const matrix>(found, result_.rows(), result_.cols());
    return result_;
  }

private:
  /// Stands for arguments that are not given; whoever needs one of them gets not-a-number.
  struct nothing {
    Scalar operator[](Eigen::Index) const { return std::numeric_limits<Scalar>::quiet_NaN(); }
  };

  checked_code<Scalar> code_;
  int coordinates_;
  matrix result_;
};

} // namespace kanexpr::runtime
