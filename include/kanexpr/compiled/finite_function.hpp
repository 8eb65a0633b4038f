#pragma once

#include <kanexpr/compiled/function.hpp>
#include <kanexpr/compiled/not_finite.hpp>

namespace kanexpr {

/// A function of several results, each of which comes with a status, also where nothing had to be solved: of
/// what is not finite it says so, and names what was not finite before it.
template <class System, auto... wanted>
struct finite_function : function<System, wanted...> {
  template <class First, class... More>
  auto operator()(const First& first, const More&... more) const noexcept {
    const auto found = function<System, wanted...>::operator()(first, more...);
    if constexpr (requires { First::SizeAtCompileTime; }) // a vector, not the time
      return told(found, first, more...);
    else
      return at_time(found, more...);
  }

private:
  using none = compiled::not_given;

  template <class Found, class... Arguments>
  static auto at_time(const Found& found, const Arguments&... arguments) {
    return told(found, arguments...);
  }

  template <class Found, class X, class P = none, class R = none, class A = none>
  static auto told(const Found& found, const X& x, const P& p = {}, const R& r = {}, const A& = {}) {
    return std::apply([&](const auto&... each) { return std::tuple(one(each, x, p, r)...); }, found);
  }

  template <class Result, class X, class P, class R>
  static with_status<Result> one(with_status<Result> result, const X& x, const P& p, const R& r) {
    if (result.status && !is_finite(result)) result.status = status("a result is not finite at this state");
    if (!result.status) result.status = compiled::not_finite<System>::cause_of(result.status, x, p, r);
    return result;
  }
  template <class Result, class X, class P, class R>
  static auto one(const Result& result, const X& x, const P& p, const R& r) {
    if constexpr (requires { typename Result::Scalar; })
      return one(with_status<Result>{result, {}}, x, p, r);
    else
      return result; // of a call that cannot be made
  }

  template <class Matrix>
  static bool is_finite(const Matrix& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i)
      if (!lower::scalar_math<typename Matrix::Scalar>::is_finite(m.data()[i])) return false;
    return true;
  }
};

} // namespace kanexpr
