#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/compiled/call.hpp>
#include <kanexpr/compiled/callable.hpp>
#include <kanexpr/compiled/code.hpp>
#include <kanexpr/compiled/digest.hpp>
#include <kanexpr/compiled/state.hpp>
#include <kanexpr/compiled/status.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/windows.hpp>
#include <kanexpr/derivation/extract_code.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/constant.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/stored_results.hpp>
#include <kanexpr/lower/tape_in_pieces.hpp>
#include <kanexpr/lower/vector_columns.hpp>
#include <kanexpr/numeric/fixed_matrix.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kanexpr {

/// Compiled evaluation of one or several results of a system: a stateless function object that neither
/// allocates nor throws. Call it as f(x), f(x, p), f(x, p, r) or f(x, p, r, a), or with the time as the first
/// argument. t is the time, x the state [q; u], p the parameters, r the inputs, and a the rates of the
/// speeds, as Eigen vectors of matching size. Second-order results take weights and directions in place of a:
/// f(x, p, r, w), f(x, p, r, v) or f(x, p, r, w, v).
template <class System, auto... wanted>
struct function : compiled::callable<function<System, wanted...>> {
  using code = compiled::code<System, wanted...>;
  static constexpr std::size_t state_size =
      static_cast<std::size_t>(compiled::survey_of<System>.coordinates + compiled::survey_of<System>.speeds);
  static constexpr std::size_t parameter_count =
      static_cast<std::size_t>(compiled::survey_of<System>.parameters);
  static constexpr std::size_t speed_count = static_cast<std::size_t>(compiled::survey_of<System>.speeds);
  static constexpr std::size_t input_count = static_cast<std::size_t>(compiled::survey_of<System>.inputs);

  /// Returns the number of operations of one call.
  static constexpr const symbolic::cost& cost() { return code::tape.cost; }

  template <class First, class... More>
  [[gnu::always_inline]] static auto called(const First& first, const More&... more) noexcept {
    return evaluate_at<false>(first, more...);
  }

  /// Evaluates the function in a constant expression, from plain arrays: `static_assert(M.constant({0.1, 0},
  /// {2.0})(0, 0) == 2)`. Several results are returned as a tuple.
  static constexpr auto constant(const std::array<double, state_size>& x,
                                 const std::array<double, parameter_count>& p,
                                 const std::array<double, input_count>& r, double t = 0) {
    static_assert(sizeof(constant_call<parameter_values<System>, input_values<System>>) != 0);
    return constant_at(x, p, r, {}, t);
  }
  static constexpr auto constant(const std::array<double, state_size>& x,
                                 const std::array<double, parameter_count>& p) {
    static_assert(sizeof(constant_call<parameter_values<System>>) != 0);
    return constant(x, p, {});
  }
  static constexpr auto constant(const std::array<double, state_size>& x) {
    static_assert(sizeof(constant_call<none>) != 0);
    return constant(x, {}, {});
  }

  /// Evaluates the function at given rates of the speeds.
  static constexpr auto constant_at(const std::array<double, state_size>& x,
                                    const std::array<double, parameter_count>& p,
                                    const std::array<double, input_count>& r,
                                    const std::array<double, speed_count>& a, double t = 0) {
    static_assert(!is_weighted,
                  "results that take weights or a direction cannot be evaluated in constant expressions");
    using symbolic::symbol_kind;
    const auto slot = lower::constant_slots<code::tape>([&](const lower::load& l) {
      const auto i = static_cast<std::size_t>(l.position);
      switch (l.from) {
      case symbol_kind::coordinate: return x[i];
      case symbol_kind::speed:
        return x[static_cast<std::size_t>(compiled::survey_of<System>.coordinates) + i];
      case symbol_kind::parameter: return p[i];
      case symbol_kind::input: return r[i];
      case symbol_kind::speed_rate: return a[i];
      case symbol_kind::time: return t;
      case symbol_kind::coordinate_rate: // not arguments of a call
      case symbol_kind::auxiliary_speed:
      case symbol_kind::multiplier:
      case symbol_kind::weight:
      case symbol_kind::direction: break;
      }
      return t;
    });
    if constexpr (sizeof...(wanted) == 1)
      return constant_result<0, wanted...>(slot);
    else
      return constant_results(slot, std::make_index_sequence<sizeof...(wanted)>{});
  }

private:
  using none = compiled::omitted;
  /// Reports required arguments that are omitted.
  template <class Parameters, class Inputs = none>
  using constant_call =
      compiled::call<System, code, double, state<System>, Parameters, Inputs, none, wanted...>;
  static constexpr none nothing{};
  static constexpr bool is_weighted = (derivation::requested<wanted>::value.is_weighted() || ...);

  template <int first, auto one, class Slots>
  static constexpr auto constant_result(const Slots& slot) {
    constexpr derivation::extent size = compiled::extent_of<one, System>;
    numeric::fixed_matrix<double, size.rows, size.columns> result;
    for (int i = 0; i < size.rows; ++i)
      for (int j = 0; j < size.columns; ++j)
        result(i, j) = slot[static_cast<std::size_t>(code::tape.results[first + i * size.columns + j])];
    return result;
  }
  template <class Slots, std::size_t... index>
  static constexpr auto constant_results(const Slots& slot, std::index_sequence<index...>) {
    return std::tuple(constant_result<first_of(index), wanted>(slot)...);
  }

  template <bool with_statuses, class Number, class Arguments>
  [[gnu::always_inline]] static auto compute(const Arguments& given) noexcept {
    return collect_from<with_statuses, Number>(lower::evaluated_tape<code, Number>(given));
  }

  /// For long functions, which are compiled once: expanded at a call, they would be optimized again at each
  /// level of inlining.
  template <bool with_statuses, class Number, class Arguments>
  [[gnu::noinline]] static auto compute_apart(const Arguments& given) noexcept {
    return compute<with_statuses, Number>(given);
  }

  /// The fourth and fifth arguments are the rates of the speeds, or the weights and the direction that
  /// second-order results take.
  template <bool with_statuses, class Time, class State, class Parameters = none, class Inputs = none,
            class Fourth = none, class Fifth = none>
  [[gnu::always_inline]] static auto evaluate(const Time& t, const State& x, const Parameters& p = {},
                                              const Inputs& r = {}, const Fourth& fourth = {},
                                              const Fifth& fifth = {}) noexcept {
    constexpr derivation::extra_arguments given =
        derivation::extra_arguments_of({&derivation::requested<wanted>::value...});
    if constexpr (!is_weighted)
      return evaluate_with<with_statuses>(t, x, p, r, fourth, nothing, nothing);
    else if constexpr (given.weights)
      return evaluate_with<with_statuses>(t, x, p, r, nothing, fourth, fifth);
    else
      return evaluate_with<with_statuses>(t, x, p, r, nothing, nothing, fourth);
  }

  template <class Weights, class Direction>
  static constexpr bool can_take() {
    if constexpr (is_weighted)
      return compiled::weighted_call<
          System, code, Weights, Direction,
          derivation::extra_arguments_of({&derivation::requested<wanted>::value...}), wanted...>::possible;
    else
      return true;
  }

  template <bool with_statuses, class Time, class State, class Parameters, class Inputs, class Accelerations,
            class Weights, class Direction>
  [[gnu::always_inline]] static auto evaluate_with(const Time& time, const State& x, const Parameters& p,
                                                   const Inputs& r, const Accelerations& a, const Weights& w,
                                                   const Direction& v) noexcept {
    using Number = typename State::Scalar;
    if constexpr (!compiled::call<System, code, Time, State, Parameters, Inputs, Accelerations,
                                  wanted...>::possible ||
                  !can_take<Weights, Direction>() ||
                  !compiled::can_call_externals<code, Number, false, wanted...>()) {
      derivation::report_in_code<compiled::surveyed<System>>();
      derivation::report_in_code<code>();
      return no_results<Number>();
    } else {
      compiled::enforce_unique_system_name<System>();
      assert_size(x, state_size), assert_size(p, parameter_count), assert_size(r, input_count);
      assert_size(w, state_size), assert_size(v, state_size + input_count);
      Number t = lower::scalar_math<Number>::from(0);
      if constexpr (!std::is_same_v<Time, none>) t = lower::scalar_math<Number>::from(time);
      const compiled::arguments<System, Number, State, Parameters, Inputs, Accelerations, Weights, Direction>
          given{t, x, p, r, a, w, v};
      if constexpr (code::tape.sizes.steps > lower::lengths_of<code>.longest_at_calls)
        return compute_apart<with_statuses, Number>(given);
      else
        return compute<with_statuses, Number>(given);
    }
  }

  /// Checks a vector of dynamic size.
  template <class Vector>
  [[gnu::always_inline]] static void assert_size([[maybe_unused]] const Vector& v,
                                                 [[maybe_unused]] std::size_t size) noexcept {
    if constexpr (!std::is_same_v<Vector, none> && compiled::entries_of<Vector>() == Eigen::Dynamic) {
      eigen_assert(static_cast<std::size_t>(v.size()) == size &&
                   "the size of a vector does not match the system");
    }
  }

  template <class Number>
  static auto no_results() {
    if constexpr (sizeof...(wanted) == 1)
      return (compiled::no_result_of<Number, wanted>(), ...);
    else
      return std::tuple(compiled::no_result_of<Number, wanted>()...);
  }

  static constexpr int checks = code::causes.sizes.count;
  static constexpr int first_check = code::tape.sizes.results - 2 * checks;

  template <bool with_statuses, class Number, class Done>
  [[gnu::always_inline]] static auto collect_from(const Done& done) noexcept {
    if constexpr (sizeof...(wanted) == 1) {
      return with_status_of<with_statuses, Number>(done, collect<Number, 0, wanted...>(done));
    } else {
      return collect_all<with_statuses, Number>(done, std::make_index_sequence<sizeof...(wanted)>{});
    }
  }

  /// Returns a result without a status if it requires no solve and no status is requested.
  template <bool with_statuses, class Number, class Done, class Result>
  [[gnu::always_inline]] static auto with_status_of(const Done& done, const Result& result) noexcept {
    if constexpr (checks == 0 && !with_statuses)
      return result;
    else
      return with_status<Result>{result, status_of<Number>(done, std::make_integer_sequence<int, checks>{})};
  }

  /// Reports the first cause, because later ones may be its consequences.
  template <class Number, class Done, int... index>
  [[gnu::always_inline]] static status status_of(const Done& done,
                                                 std::integer_sequence<int, index...>) noexcept {
    if constexpr (checks == 0) {
      return {};
    } else {
      int first = -1;
      const int order[]{
          (first = passes<Number, checks - 1 - index>(done) ? first : checks - 1 - index, 0)...};
      static_cast<void>(order);
      const std::string_view cause = code::causes[first < 0 ? 0 : first];
      return first < 0 ? status() : status(cause);
    }
  }

  template <class Number, int index, class Done>
  [[gnu::always_inline]] static bool passes(const Done& done) noexcept {
    constexpr bool of_finiteness = code::checks_finiteness && index == checks - 1;
    return lower::passes<of_finiteness, Number>(done.template result<first_check + 2 * index>(),
                                                done.template result<first_check + 2 * index + 1>(),
                                                base::least_singularity_measure<Number>());
  }

  template <class Number, int first, auto one, class Done>
  [[gnu::always_inline]] static auto collect(const Done& done) noexcept {
    constexpr derivation::extent size = compiled::extent_of<one, System>;
    if constexpr (size.scalar) {
      return Number(done.template result<first>());
    } else {
      Eigen::Matrix<Number, size.rows, size.columns> m;
      fill<Number, first, size.rows, size.columns>(done, m);
      return m;
    }
  }

  /// The entries of a result that are not zero in every state, or those among them that are numbers.
  template <int first, int count, bool only_numbers = false>
  class nonzero_entries {
    struct found {
      int entry[static_cast<std::size_t>(count)]{}, size = 0;

      constexpr found() {
        for (int i = 0; i < count; ++i)
          if (!is_zero(first + i) && (!only_numbers || is_number(first + i))) entry[size++] = i;
      }
    };
    static constexpr found all{};

    template <class>
    struct list;
    template <int... index>
    struct list<std::integer_sequence<int, index...>> {
      using type = std::integer_sequence<int, all.entry[index]...>;
    };

  public:
    using type = typename list<std::make_integer_sequence<int, all.size>>::type;
  };

  template <class Matrix>
  [[gnu::always_inline]] static void set_zero(Matrix& m) noexcept {
    const auto zero = lower::scalar_math<typename Matrix::Scalar>::from(0);
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = zero;
  }

  template <class Number, int first, int rows, int columns, class Done, class Matrix>
  [[gnu::always_inline]] static void fill(const Done& done, Matrix& m) noexcept {
    if constexpr (lower::is_long<code>) {
      set_zero(m);
      lower::stored_results<code, Done, first, rows, columns, Matrix::IsRowMajor>::copy(done.memory(),
                                                                                        m.data());
      fill<first, columns>(done, m, typename nonzero_entries<first, rows * columns, true>::type{});
    } else if constexpr (has_many_zeros(first, rows * columns)) {
      set_zero(m);
      fill<first, columns>(done, m, typename nonzero_entries<first, rows * columns>::type{});
    } else {
      fill<first, columns>(done, m, std::make_integer_sequence<int, rows * columns>{});
    }
  }

  // a separate function, not a lambda: compilers do not inline lambdas here, and the slots stay in memory
  // coeffRef, because the operators of a matrix are templates, among which compilers choose at length
  template <int first, int columns, class Done, class Matrix, int... entry>
  [[gnu::always_inline]] static void fill([[maybe_unused]] const Done& done, [[maybe_unused]] Matrix& m,
                                          std::integer_sequence<int, entry...>) noexcept {
    const int order[]{0,
                      (put_entry<first + entry>(done, m.coeffRef(entry / columns, entry % columns)), 0)...};
    static_cast<void>(order);
  }
  template <int index, class Done, class Number>
  [[gnu::always_inline]] static void put_entry(const Done& done, Number& entry) noexcept {
    entry = done.template result<index>();
  }

  /// Writes in place, because results as large as the derivatives of an arm should not be copied.
  template <bool with_statuses, class Number, class Done, std::size_t... index>
  [[gnu::always_inline]] static auto collect_all(const Done& done, std::index_sequence<index...>) noexcept {
    std::tuple<decltype(with_status_of<with_statuses, Number>(
        done, collect<Number, first_of(index), wanted>(done)))...>
        all;
    (put<first_of(index), wanted, Number>(done, std::get<index>(all)), ...);
    return all;
  }

  template <int first, auto one, class Number, class Done, class Result>
  [[gnu::always_inline]] static void put(const Done& done, Result& into) noexcept {
    constexpr derivation::extent size = compiled::extent_of<one, System>;
    if constexpr (requires { into.status; })
      into.status = status_of<Number>(done, std::make_integer_sequence<int, checks>{});
    if constexpr (!size.scalar)
      fill<Number, first, size.rows, size.columns>(done, into);
    else if constexpr (requires { into.value; })
      into.value = done.template result<first>();
    else
      static_cast<Number&>(into) =
          done.template result<first>(); // a scalar of class type may also carry a status
  }

protected:
  static constexpr int first_of(std::size_t which) {
    const derivation::extent sizes[]{compiled::extent_of<wanted, System>...};
    int first = 0;
    for (std::size_t i = 0; i < which; ++i) first += sizes[i].rows * sizes[i].columns;
    return first;
  }

  /// Whether an entry is zero in every state.
  static constexpr bool is_zero(int entry) {
    return is_number(entry) && code::tape.numbers[code::tape.results[entry]].is_zero();
  }
  static constexpr bool is_number(int entry) { return code::tape.results[entry] < code::tape.sizes.numbers; }
  static consteval bool has_many_zeros(int first, int count) {
    constexpr int fewest = 32; // fewer are stored one by one, which allows compilers to omit all of them
    int zeros = 0;
    for (int i = 0; i < count; ++i) zeros += is_zero(first + i) ? 1 : 0;
    return zeros >= fewest && 2 * zeros >= count;
  }

  /// Windows as wide as a register that contain the entries of a matrix that can differ from zero.
  template <class Matrix, int first>
  struct nonzero_windows {
    static constexpr int rows = static_cast<int>(Matrix::RowsAtCompileTime),
                         columns = static_cast<int>(Matrix::ColsAtCompileTime);
    static constexpr compiled::windows<rows * columns, lower::lanes_for_columns<typename Matrix::Scalar>()>
        value{[](int i) {
          const int entry = Matrix::IsRowMajor ? i : i % rows * columns + i / rows;
          return !is_zero(first + entry);
        }};
  };

  /// Returns the results, each with a status if requested, even if no equations had to be solved.
  template <bool with_statuses, class First, class... More>
  [[gnu::always_inline]] static auto evaluate_at(const First& first, const More&... more) noexcept {
    if constexpr (requires { First::SizeAtCompileTime; }) // the first argument is a vector, not the time
      return evaluate<with_statuses>(compiled::omitted{}, first, more...);
    else if constexpr (compiled::first_is_omitted<More...>)
      static_assert(sizeof(First) == 0, "a result requires a state; call it as f(t, x, p, r)");
    else
      return evaluate<with_statuses>(first, more...);
  }
};

} // namespace kanexpr
