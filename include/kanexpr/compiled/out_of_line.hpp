#pragma once

#include <kanexpr/compiled/finite_function.hpp>

namespace kanexpr {

namespace compiled {

/// One result with its status, whether or not something was solved for it: its type follows from its size
/// alone.
template <class System, auto wanted, class T>
auto stated_result() {
  constexpr derivation::extent size = extent_of<wanted, System>;
  if constexpr (size.scalar)
    return with_status<T>{};
  else
    return with_status<Eigen::Matrix<T, size.rows, size.columns>>{};
}

/// The results of a function, each with its status.
template <class Function>
struct stated;
template <class System_, auto... wanted>
struct stated<function<System_, wanted...>> {
  using System = System_;
  template <class T>
  using results = std::tuple<decltype(stated_result<System, wanted, T>())...>;
};
template <class System_, auto wanted>
struct stated<function<System_, wanted>> {
  using System = System_;
  template <class T>
  using results = decltype(stated_result<System, wanted, T>());
};
template <class System, auto... wanted>
struct stated<finite_function<System, wanted...>> : stated<function<System, wanted...>> {};

template <class T, class Found>
void put(with_status<T>& result, const Found& found) {
  if constexpr (requires { result.value; })
    result.value = found;
  else
    static_cast<T&>(result) = found;
  result.status = status_of(found);
}
template <class... T, class... Found>
void put(std::tuple<T...>& results, const std::tuple<Found...>& found) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (put(std::get<i>(results), std::get<i>(found)), ...);
  }(std::index_sequence_for<T...>{});
}

template <class System, class T>
struct vectors {
  using state = Eigen::Matrix<T, survey_of<System>.coordinates + survey_of<System>.speeds, 1>;
  using parameters = Eigen::Matrix<T, survey_of<System>.parameters, 1>;
  using inputs = Eigen::Matrix<T, survey_of<System>.inputs, 1>;
  using rates = Eigen::Matrix<T, survey_of<System>.speeds, 1>;
};

/// The code of a function for one type of scalars, which stands once in a program. `extern template` of it
/// leaves the derivation to the file that instantiates it.
template <class T, class Function>
struct instance {
  using vectors = compiled::vectors<typename stated<Function>::System, T>;
  using results = typename stated<Function>::template results<T>;

  [[gnu::noinline]] static results evaluate(const T& t, const typename vectors::state& x,
                                            const typename vectors::parameters& p,
                                            const typename vectors::inputs& r) noexcept;
};
template <class T, class Function>
typename instance<T, Function>::results
instance<T, Function>::evaluate(const T& t, const typename vectors::state& x,
                                const typename vectors::parameters& p,
                                const typename vectors::inputs& r) noexcept {
  results all{};
  put(all, Function{}(t, x, p, r));
  return all;
}

/// The same of a function that is given the rates of the speeds.
template <class T, class Function>
struct instance_at_rates {
  using vectors = compiled::vectors<typename stated<Function>::System, T>;
  using results = typename stated<Function>::template results<T>;

  [[gnu::noinline]] static results evaluate(const T& t, const typename vectors::state& x,
                                            const typename vectors::parameters& p,
                                            const typename vectors::inputs& r,
                                            const typename vectors::rates& a) noexcept;
};
template <class T, class Function>
typename instance_at_rates<T, Function>::results instance_at_rates<T, Function>::evaluate(
    const T& t, const typename vectors::state& x, const typename vectors::parameters& p,
    const typename vectors::inputs& r, const typename vectors::rates& a) noexcept {
  results all{};
  put(all, Function{}(t, x, p, r, a));
  return all;
}

/// A vector as it is passed out of line: itself where it is one of that type, else a copy.
template <class Vector, class Given>
decltype(auto) passed(const Given& given) {
  if constexpr (std::is_base_of_v<Vector, Given>) {
    return static_cast<const Vector&>(given);
  } else {
    Vector copy;
    for (Eigen::Index i = 0; i < copy.size(); ++i)
      copy(i) = lower::scalar_math<typename Vector::Scalar>::from(given[i]);
    return copy;
  }
}

/// Whether a vector can be passed. A call with another one is left to the function itself, which says what is
/// wrong with it.
template <class System, symbols_of which, class Given>
constexpr bool can_be_passed() {
  if constexpr (std::is_same_v<Given, not_given>)
    return false;
  else
    return (entries_of<Given>() == Eigen::Dynamic ||
            entries_of<Given>() == range_of(which, survey_of<System>).size) &&
           decltype(belonging_of(static_cast<const Given*>(nullptr)))::template fits<System, which>;
}

} // namespace compiled

/// A function whose code stands once in the program, for each type of scalars, and is called there, with the
/// same results to the last bit. Each of them has a status beside it.
///
/// `function<System, …>` itself is expanded wherever it is called, which is what a control loop wants. This
/// one costs the compiler the same once, however many calls there are.
template <class Function>
struct out_of_line {
  template <class Time, class X, class P, class R>
  auto operator()(const Time& t, const X& x, const P& p, const R& r) const noexcept {
    using System = typename compiled::stated<Function>::System;
    using T = typename X::Scalar;
    using vectors = compiled::vectors<System, T>;
    using compiled::symbols_of;
    if constexpr (compiled::can_be_passed<System, symbols_of::state, X>() &&
                  compiled::can_be_passed<System, symbols_of::parameters, P>() &&
                  compiled::can_be_passed<System, symbols_of::inputs, R>())
      return compiled::instance<T, Function>::evaluate(
          lower::scalar_math<T>::from(t), compiled::passed<typename vectors::state>(x),
          compiled::passed<typename vectors::parameters>(p), compiled::passed<typename vectors::inputs>(r));
    else
      return Function{}(t, x, p, r);
  }
  template <class Time, class X, class P, class R, class A>
  auto operator()(const Time& t, const X& x, const P& p, const R& r, const A& a) const noexcept {
    using T = typename X::Scalar;
    using vectors = compiled::vectors<typename compiled::stated<Function>::System, T>;
    return compiled::instance_at_rates<T, Function>::evaluate(
        lower::scalar_math<T>::from(t), compiled::passed<typename vectors::state>(x),
        compiled::passed<typename vectors::parameters>(p), compiled::passed<typename vectors::inputs>(r),
        compiled::passed<typename vectors::rates>(a));
  }
};

} // namespace kanexpr
