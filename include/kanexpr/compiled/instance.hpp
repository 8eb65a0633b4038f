#pragma once

#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <Eigen/Core>
#include <cstdint>
#include <tuple>
#include <type_traits>

namespace kanexpr {

template <class System, auto... wanted>
struct function;
template <class System, auto... wanted>
struct finite_function;

namespace compiled {

/// Complete only in files that can derive functions.
template <class System, auto... wanted>
struct derives;

/// The shape of a result: `rows`, `columns`, and whether it is a scalar.
template <class System, auto wanted>
struct result_shape;
template <class System, mechanics::quantity wanted>
struct result_shape<System, wanted> {
  static constexpr const mechanics::result_row& row = mechanics::row_of(wanted);
  static constexpr int rows = survey_of<System>.count(row.rows);
  static constexpr int columns = survey_of<System>.count(row.columns);
  static constexpr bool is_scalar = row.rows == mechanics::extent_by::scalar;
};

/// A result with a status, even if no equations were solved for it, so that its type depends only on its
/// shape.
template <class System, auto wanted, class Number>
auto result_with_status() {
  using shape = result_shape<System, wanted>;
  if constexpr (shape::is_scalar)
    return with_status<Number>{};
  else
    return with_status<Eigen::Matrix<Number, shape::rows, shape::columns>>{};
}

/// The results of a function, each with a status.
template <class Function>
struct results_with_status;
template <class System_, auto... wanted>
struct results_with_status<function<System_, wanted...>> {
  using System = System_;
  template <class Number>
  using results = std::tuple<decltype(result_with_status<System, wanted, Number>())...>;
};
template <class System_, auto wanted>
struct results_with_status<function<System_, wanted>> {
  using System = System_;
  template <class Number>
  using results = decltype(result_with_status<System, wanted, Number>());
};
template <class System, auto... wanted>
struct results_with_status<finite_function<System, wanted...>>
    : results_with_status<function<System, wanted...>> {};

template <class System, class Number>
struct vectors {
  using state = Eigen::Matrix<Number, survey_of<System>.coordinates + survey_of<System>.speeds, 1>;
  using parameters = Eigen::Matrix<Number, survey_of<System>.parameters, 1>;
  using inputs = Eigen::Matrix<Number, survey_of<System>.inputs, 1>;
  using rates = Eigen::Matrix<Number, survey_of<System>.speeds, 1>;
};

/// The code of a function for one scalar type, compiled once per program, in the file that instantiates it
/// explicitly; other files declare it by `extern template`.
///
/// Eigen aligns vectors according to the vector instructions enabled in a file. The alignment is part of the
/// name, so that files with different vector layouts cannot be linked together.
template <class Number, class Function, int alignment = EIGEN_MAX_STATIC_ALIGN_BYTES>
struct instance {
  using vectors = compiled::vectors<typename results_with_status<Function>::System, Number>;
  using results = typename results_with_status<Function>::template results<Number>;

  [[gnu::noinline]] static results evaluate(const Number& t, const typename vectors::state& x,
                                            const typename vectors::parameters& p,
                                            const typename vectors::inputs& r) noexcept;
  /// Returns the digest of the code that is compiled into the library.
  [[gnu::noinline]] static std::uint64_t digest() noexcept;
};

/// The code of a function at given rates of the speeds.
template <class Number, class Function, int alignment = EIGEN_MAX_STATIC_ALIGN_BYTES>
struct instance_at_rates {
  using vectors = compiled::vectors<typename results_with_status<Function>::System, Number>;
  using results = typename results_with_status<Function>::template results<Number>;

  [[gnu::noinline]] static results evaluate(const Number& t, const typename vectors::state& x,
                                            const typename vectors::parameters& p,
                                            const typename vectors::inputs& r,
                                            const typename vectors::rates& a) noexcept;
};

/// Returns a vector in the form in which it is passed out of line: the argument itself if it has that type,
/// otherwise a copy; uninitialized if omitted.
template <class Vector, class Given>
decltype(auto) forwarded(const Given& given) {
  if constexpr (std::is_same_v<Given, omitted>) {
    return Vector();
  } else if constexpr (std::is_base_of_v<Vector, Given>) {
    return static_cast<const Vector&>(given);
  } else {
    Vector copy;
    for (Eigen::Index i = 0; i < copy.size(); ++i)
      copy(i) = lower::scalar_math<typename Vector::Scalar>::from(given[i]);
    return copy;
  }
}

} // namespace compiled

} // namespace kanexpr
