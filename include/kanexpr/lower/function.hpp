#pragma once

#include <kanexpr/derive/derivation.hpp>
#include <kanexpr/lower/evaluate.hpp>
#include <kanexpr/lower/state.hpp>

#include <tuple>

namespace kanexpr {

namespace lower {

/// The tape for some results of a system, derived once for each set of them.
template <class System, auto... wanted>
struct code {
  static constexpr derive::outcome outcome = [] {
    if (survey_of<System>.mistake) return derive::outcome{};
    return derive::derived<System, wanted...>();
  }();
  static constexpr const auto& tape = outcome.tape;
  static constexpr mechanics::problem mistake = outcome.mistake;
  static_assert(derive::tell<code>());
};

/// What a load finds in the arguments of a call.
template <class System, class T, class X, class P, class R>
struct arguments {
  const T& t;
  const X& x;
  const P& p;
  const R& r;

  template <symbolic::symbol_kind from, int position>
  [[gnu::always_inline]] T operator()() const noexcept {
    using symbolic::symbol_kind;
    if constexpr (from == symbol_kind::time) return t;
    else if constexpr (from == symbol_kind::coordinate) return T(x[position]);
    else if constexpr (from == symbol_kind::speed) return T(x[survey_of<System>.coordinates + position]);
    else if constexpr (from == symbol_kind::parameter) return T(p[position]);
    else return T(r[position]);
  }
};

/// What stands for arguments that are not given.
struct not_given {};

template <auto wanted, class System>
inline constexpr derive::extent extent_of = derive::request<wanted>::of(survey_of<System>);

template <class T, derive::extent size>
struct result_of {
  using type = Eigen::Matrix<T, size.rows, size.columns>;
};
template <class T, derive::extent size>
  requires(size.rows == 1 && size.columns == 1)
struct result_of<T, size> {
  using type = T;
};

} // namespace lower

/// Compiled evaluation of one or several results of a system: a function object without state, which allocates nothing
/// and throws nothing. Called as f(x), f(x, p), f(x, p, r) or with the time in front; x is the state [q; u],
/// p the parameters, r the inputs, any Eigen vectors of their sizes.
template <class System, auto... wanted>
struct function {
  using code = lower::code<System, wanted...>;

  /// Operations of one call.
  static constexpr const symbolic::cost& cost() { return code::tape.cost; }

  template <class X>
  [[gnu::always_inline]] auto operator()(const Eigen::MatrixBase<X>& x) const noexcept {
    return evaluate(typename X::Scalar(0), x.derived(), lower::not_given{}, lower::not_given{});
  }
  template <class X, class P>
  [[gnu::always_inline]] auto operator()(const Eigen::MatrixBase<X>& x, const Eigen::MatrixBase<P>& p) const noexcept {
    return evaluate(typename X::Scalar(0), x.derived(), p.derived(), lower::not_given{});
  }
  template <class X, class P, class R>
  [[gnu::always_inline]] auto operator()(const Eigen::MatrixBase<X>& x, const Eigen::MatrixBase<P>& p,
                                         const Eigen::MatrixBase<R>& r) const noexcept {
    return evaluate(typename X::Scalar(0), x.derived(), p.derived(), r.derived());
  }
  template <class Time, class X, class P, class R>
  [[gnu::always_inline]] auto operator()(const Time& t, const Eigen::MatrixBase<X>& x, const Eigen::MatrixBase<P>& p,
                                         const Eigen::MatrixBase<R>& r) const noexcept {
    return evaluate(typename X::Scalar(t), x.derived(), p.derived(), r.derived());
  }

private:
  template <class T, class X, class P, class R>
  [[gnu::always_inline]] static auto evaluate(const T& t, const X& x, const P& p, const R& r) noexcept {
    const lower::evaluation<code, T> done(lower::arguments<System, T, X, P, R>{t, x, p, r});
    if constexpr (sizeof...(wanted) == 1) {
      return collect<T, 0, wanted...>(done);
    } else {
      return collect_all<T>(done, std::make_index_sequence<sizeof...(wanted)>{});
    }
  }

  template <class T, int first, auto one>
  [[gnu::always_inline]] static auto collect(const lower::evaluation<code, T>& done) noexcept {
    constexpr derive::extent size = lower::extent_of<one, System>;
    if constexpr (size.rows == 1 && size.columns == 1) {
      return T(done.template result<first>());
    } else {
      Eigen::Matrix<T, size.rows, size.columns> m;
      [&]<int... i>(std::integer_sequence<int, i...>) {
        const int order[]{0, (m(i / size.columns, i % size.columns) = done.template result<first + i>(), 0)...};
        static_cast<void>(order);
      }(std::make_integer_sequence<int, size.rows * size.columns>{});
      return m;
    }
  }

  static constexpr int first_of(std::size_t which) {
    const derive::extent sizes[]{lower::extent_of<wanted, System>...};
    int first = 0;
    for (std::size_t i = 0; i < which; ++i) first += sizes[i].rows * sizes[i].columns;
    return first;
  }

  template <class T, std::size_t... i>
  [[gnu::always_inline]] static auto collect_all(const lower::evaluation<code, T>& done,
                                                 std::index_sequence<i...>) noexcept {
    return std::tuple(collect<T, first_of(i), wanted>(done)...);
  }
};

} // namespace kanexpr
