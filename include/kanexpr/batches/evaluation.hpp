#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batches/row_arguments.hpp>
#include <kanexpr/compiled/finite_function.hpp>
#include <kanexpr/compiled/not_finite.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <Eigen/Core>
#include <limits>
#include <tuple>
#include <utility>

/// One evaluation of a compiled function for as many systems as a pack has lanes.
namespace kanexpr::batches {

/// Accumulates whether packs are finite in all lanes; the lanes are combined only once, at the end.
template <class Pack>
class finiteness {
public:
  [[gnu::always_inline]] void include(const Pack& pack) {
#if !defined(__FINITE_MATH_ONLY__) || !__FINITE_MATH_ONLY__
    if constexpr (lower::vector_extension<Pack>) {
      const auto exponent = __builtin_bit_cast(bits, pack) & infinity;
      wrong_ |= exponent == infinity;
      return;
    }
#endif
    is_wrong_ |= !lower::scalar_math<Pack>::is_finite(pack);
  }
  [[gnu::always_inline]] bool all_finite() const {
    if constexpr (lower::vector_extension<Pack>)
      return !is_wrong_ && !numeric::detail::is_set_in_a_lane(wrong_);
    else
      return !is_wrong_;
  }

private:
  using number = numeric::detail::number_of<Pack>;
  using bits = numeric::detail::bits_of<Pack>;
  static constexpr auto infinity =
      __builtin_bit_cast(numeric::detail::number_bits<Pack>, std::numeric_limits<number>::infinity());

  decltype(bits{} == bits{}) wrong_{};
  bool is_wrong_ = false;
};

/// The results of a function to be evaluated, and whether they must be finite.
template <class Function>
struct evaluated;
template <class System_, auto... wanted>
struct evaluated<function<System_, wanted...>> {
  using System = System_;
  using function = kanexpr::function<System, wanted...>;
  static constexpr bool must_be_finite = false;
  static constexpr std::size_t results = sizeof...(wanted);
  template <class Number>
  using matrices = std::tuple<many<Eigen::Matrix<Number, compiled::result_shape<System, wanted>::rows,
                                                 compiled::result_shape<System, wanted>::columns>>...>;
};
template <class System, auto... wanted>
struct evaluated<finite_function<System, wanted...>> : evaluated<function<System, wanted...>> {
  static constexpr bool must_be_finite = true;
};

/// `decltype` of a constant function is const-qualified.
template <class Function>
struct evaluated<const Function> : evaluated<Function> {};

/// The destination of a result of several systems: entry i of the first system is at `first[i * stride]`.
template <class Number>
struct strided_output {
  Number* first;
  Eigen::Index stride;
};

template <class Pack, class Result>
[[gnu::always_inline]] inline const auto& entry_of(const Result& result, [[maybe_unused]] int i) {
  if constexpr (requires { result.value; })
    return result.value;
  else if constexpr (requires { typename Result::Scalar; })
    return result.data()[i];
  else
    return result;
}

template <class Pack, class Number, class Result, int... index>
[[gnu::always_inline]] inline void put(const strided_output<Number>& to, const Result& result,
                                       [[maybe_unused]] finiteness<Pack>& all,
                                       std::integer_sequence<int, index...>) {
  const auto one = [&](int entry) __attribute__((always_inline)) {
    const Pack& pack = entry_of<Pack>(result, entry);
    all.include(pack);
    put_at(to.first + entry * to.stride, pack);
  };
  (one(index), ...);
}

/// Evaluates a function and stores its results. The status is that of the first result that could not be
/// computed in all lanes.
template <class Function, class Pack, class Number, class... Arguments>
[[gnu::noinline]] status evaluate_pack(const strided_output<Number>* to,
                                       const Arguments&... arguments) noexcept {
  using described = evaluated<Function>;
  using matrices = typename described::template matrices<Number>;
  const auto found = typename described::function{}(arguments...);
  finiteness<Pack> all;
  status first;
  const auto keep = [&]<std::size_t place>(const auto& result) __attribute__((always_inline)) {
    put<Pack>(to[place], result, all,
              std::make_integer_sequence<int, std::tuple_element_t<place, matrices>::entries>{});
    if (first) first = status_of(result);
  };
  if constexpr (described::results == 1)
    keep.template operator()<0>(found);
  else
    [&]<std::size_t... place>(std::index_sequence<place...>) __attribute__((always_inline)) {
      (keep.template operator()<place>(std::get<place>(found)), ...);
    }(std::make_index_sequence<described::results>{});
  if (described::must_be_finite && first && !all.all_finite()) return compiled::results_not_finite;
  return first;
}

/// Returns the cause of a failure as the function for a single system would report it.
template <class Function, class State, class Parameters = compiled::omitted, class Inputs = compiled::omitted,
          class... Rates>
status cause_of(const status& failure, const State& x, const Parameters& p = {}, const Inputs& r = {},
                const Rates&...) {
  using described = evaluated<Function>;
  if constexpr (described::must_be_finite)
    return compiled::not_finite<typename described::System>::cause_of(failure, x, p, r);
  else
    return failure;
}

} // namespace kanexpr::batches
