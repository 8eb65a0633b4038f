#pragma once

#include <kanexpr/base/text.hpp>
#include <kanexpr/describe/composed.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <concepts>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// User functions in models: functions of scalars for which the program also provides derivatives.
namespace kanexpr {

namespace symbolic {
class expression; // the expressions of builders, which models do not need
}

namespace describe {

/// The last part of a message about a user function.
struct external_mistake {
  std::string_view whose = "", what = "", numbers = "";
};

/// The description of a user function.
struct external_record {
  const symbolic::external_function* function = nullptr; ///< null if there is a mistake
  std::string_view called{};
  external_mistake mistake{};
  int operands = 0; ///< the accepted number of operands if it is called with a different number
};

/// A derivative of a function: the operands with respect to which it is taken, in ascending order, so that
/// mixed derivatives coincide. As a template argument it is a number with one digit per operand: 13 for the
/// derivative with respect to the first and third.
struct derivative_of {
  int order = 0;
  int by[symbolic::max_derivatives]{};

  constexpr explicit derivative_of(int digits) {
    for (int rest = digits; rest != 0; rest /= 10) ++order;
    for (int k = order - 1; k >= 0; --k, digits /= 10) by[k] = digits % 10 - 1;
  }
  constexpr int with_operand(int operand) const {
    int digits = 0;
    bool is_in = false;
    for (int k = 0; k < order; ++k) {
      if (!is_in && operand < by[k]) digits = 10 * digits + operand + 1, is_in = true;
      digits = 10 * digits + by[k] + 1;
    }
    return is_in ? digits : 10 * digits + operand + 1;
  }
};
inline constexpr int no_derivative = 0;

template <class Operand>
concept counts_as_number =
    std::convertible_to<Operand, double> && !std::same_as<std::remove_cvref_t<Operand>, bool> &&
    !std::is_pointer_v<std::remove_cvref_t<Operand>>;

/// Describes a numeric type that cannot represent every double, so that values would be truncated or rounded
/// silently; empty for all other types.
template <class Given>
constexpr std::string_view narrower_than_double() {
  using number = std::remove_cvref_t<Given>;
  if constexpr (std::is_integral_v<number> || std::is_enum_v<number>)
    return "integers, not double";
  else if constexpr (std::is_floating_point_v<number>)
    return std::numeric_limits<number>::digits < std::numeric_limits<double>::digits ? "float, not double"
                                                                                     : "";
  else
    return "";
}

/// Describes the first argument with such a type if the argument types of a function are fixed.
template <class Call>
inline constexpr std::string_view narrower_argument{};
template <class Function, class Result, class... Arguments, bool never_throws>
inline constexpr std::string_view
    narrower_argument<Result (Function::*)(Arguments...) const noexcept(never_throws)> = [] {
      std::string_view found;
      ((found = found.empty() ? narrower_than_double<Arguments>() : found), ...);
      return found;
    }();
template <class Function, class Result, class... Arguments, bool never_throws>
inline constexpr std::string_view
    narrower_argument<Result (Function::*)(Arguments...) noexcept(never_throws)> =
        narrower_argument<Result (Function::*)(Arguments...) const>;

/// A function and its derivatives, each of them a class whose objects are called with scalars. For several
/// operands, or for order two and higher, a derivative returns an object indexed by [i] or [i][j].
template <text called, int operands, class Function, class... Derivatives>
struct external_family {
  static constexpr std::string_view name = called.view();
  static constexpr int count = operands, derivatives = static_cast<int>(sizeof...(Derivatives));
  template <int order>
  using one = std::tuple_element_t<static_cast<std::size_t>(order), std::tuple<Function, Derivatives...>>;

  template <int order, class Number, std::size_t... index>
  static constexpr bool takes(std::index_sequence<index...>) {
    return std::is_default_constructible_v<one<order>> &&
           std::is_invocable_v<one<order>, decltype((void(index), std::declval<const Number&>()))...>;
  }
  /// Whether the function or derivative can be called with `many` scalars.
  template <int order, class Number, int many = operands>
  static constexpr bool is_called_with =
      takes<order, Number>(std::make_index_sequence<static_cast<std::size_t>(many)>{});

  /// A missing entry of a derivative.
  struct no_entry {};
  template <class Given>
  static constexpr bool has_entry_for_each() {
    if constexpr (!requires(const Given& g) { g[0]; })
      return false;
    else if constexpr (requires { std::tuple_size<Given>::value; })
      return std::tuple_size_v<Given> == static_cast<std::size_t>(operands);
    else
      return true;
  }

  /// Returns an entry of a derivative; for a single operand, the derivative may be the number itself.
  template <int digits, int level, class Given>
  static constexpr decltype(auto) entry(const Given& given) {
    constexpr derivative_of path(digits);
    constexpr int operand = level < path.order ? path.by[level] : 0;
    if constexpr (level == path.order)
      return given;
    else if constexpr (has_entry_for_each<Given>())
      return entry<digits, level + 1>(given[operand]);
    else if constexpr (operands == 1 && !requires { given[0]; })
      return entry<digits, path.order>(given);
    else
      return no_entry();
  }
  template <int order, class Number, std::size_t... index>
  static constexpr auto given_with(std::index_sequence<index...>)
      -> std::invoke_result_t<one<order>, decltype((void(index), std::declval<const Number&>()))...>;
  template <int digits, class Number>
  using value_with = decltype(entry<digits, 0>(given_with<derivative_of(digits).order, Number>(
      std::make_index_sequence<static_cast<std::size_t>(operands)>{})));

  template <int digits, class Number>
  static constexpr bool accepts() {
    if constexpr (is_called_with<derivative_of(digits).order, Number>)
      return std::is_constructible_v<Number, value_with<digits, Number>>;
    else
      return false;
  }

  static constexpr int first_of_order(int order) {
    int digits = no_derivative;
    while (order-- > 0) digits = 10 * digits + 1;
    return digits;
  }
  /// The mistake in the function or in one of its derivatives.
  template <int order>
  static constexpr external_mistake mistake_of(std::string_view whose) {
    if constexpr (!is_called_with<order, double>) {
      return {whose, order == 0 ? " cannot be called with double arguments" : " does not return numbers"};
    } else {
      using given = value_with<first_of_order(order), double>;
      if constexpr (requires { &one<order>::operator(); })
        if (constexpr std::string_view taken = narrower_argument<decltype(&one<order>::operator())>;
            !taken.empty())
          return {whose, " takes ", taken};
      if constexpr (!counts_as_number<given>)
        return {whose, order == 0 ? " does not return a number" : " does not return numbers"};
      else if (constexpr std::string_view lesser = narrower_than_double<given>(); !lesser.empty())
        return {whose, " returns ", lesser};
      else
        return {};
    }
  }

  static constexpr external_mistake mistake = [] {
    external_mistake found;
    if (!symbolic::is_name(name))
      found.whose = ", which is not a valid function name";
    else if (operands > symbolic::max_operands)
      found.whose = " with more than nine arguments";
    else if (sizeof...(Derivatives) >= symbolic::max_derivatives)
      found.whose = ", which has more than three derivatives";
    constexpr std::string_view whose[]{", which", ", whose first derivative", ", whose second derivative",
                                       ", whose third derivative"};
    [&]<int... order>(std::integer_sequence<int, order...>) {
      ((found = found.whose.empty() ? mistake_of<order>(whose[order]) : found), ...);
    }(std::make_integer_sequence<int, 1 + static_cast<int>(sizeof...(Derivatives))>{});
    return found;
  }();

  /// The accepted number of operands if the function is called with a different number.
  static constexpr int accepted_operand_count = [] {
    int found = 0;
    if constexpr (!is_called_with<0, double>)
      [&]<int... place>(std::integer_sequence<int, place...>) {
        ((found == 0 && is_called_with<0, double, 1 + place> ? void(found = 1 + place) : void()), ...);
      }(std::make_integer_sequence<int, symbolic::max_operands>{});
    return found;
  }();
};

template <class Member>
constexpr const symbolic::external_function* linked() {
  static_assert(sizeof(symbolic::external_registration<Member, &Member::function>) != 0);
  return &Member::function;
}

/// The function, or one of its derivatives, for the graph and for all scalar types. A derivative that is not
/// provided has no value.
template <class Family, int digits>
struct external_member {
  static constexpr derivative_of path{digits};
  static constexpr bool is_given = path.order <= Family::derivatives,
                        has_slopes = path.order < Family::derivatives;

  /// Whether the function can be called with scalars of this type.
  template <class Number>
  static constexpr bool accepts() {
    return Family::template accepts<digits, Number>();
  }
  template <class Number>
  [[gnu::always_inline]] static constexpr Number value(const auto&... x) {
    return Number(Family::template entry<digits, 0>(typename Family::template one<path.order>{}(x...)));
  }

private:
  template <std::size_t... index>
  static constexpr double value_of(const double* x, std::index_sequence<index...>) {
    return value<double>(x[index]...);
  }
  static constexpr double value_at(const double* x) {
    return value_of(x, std::make_index_sequence<static_cast<std::size_t>(Family::count)>{});
  }

  template <class Operands>
  struct slopes;
  template <int... index>
  struct slopes<std::integer_sequence<int, index...>> {
    static constexpr const symbolic::external_function* all[]{
        linked<external_member<Family, path.with_operand(index)>>()...};
  };

  static constexpr symbolic::external_function described() {
    symbolic::external_function f;
    f.called = f.original = base::name(Family::name);
    f.operands = Family::count;
    f.order = path.order;
    for (int k = 0; k < path.order; ++k) {
      f.by[k] = path.by[k];
      f.called.append("_");
      f.called.append(path.by[k] + 1);
    }
    if constexpr (is_given) {
      f.value = &value_at;
      f.slopes = slopes<std::make_integer_sequence<int, Family::count>>::all;
    }
    return f;
  }

public:
  static constexpr symbolic::external_function function = described();
};

template <class Family>
inline constexpr external_record external_of = [] {
  external_record r;
  r.called = Family::name;
  r.mistake = Family::mistake;
  r.operands = Family::accepted_operand_count;
  if constexpr (Family::mistake.whose.empty()) r.function = linked<external_member<Family, no_derivative>>();
  return r;
}();

} // namespace describe

/// A user function, which models call like built-in ones: `constexpr external<"tyre", F, dF> tyre;` and
/// `tyre(slip, load)`. F is a class whose objects take scalars of a type T and return a T; dF returns the
/// derivatives with respect to the operands: a number for one operand, otherwise an object indexed by [i]. A
/// second derivative, needed to linearize an expression that contains a first derivative, is indexed by
/// [i][j], and a third by [i][j][k]. Derivatives that are never needed may be omitted.
template <text called, class Function, class... Derivatives>
struct external {
  template <class... Operands>
    requires describe::any_of_a_model<Operands...>
  constexpr auto operator()(const Operands&... x) const {
    constexpr int count = static_cast<int>(sizeof...(Operands));
    auto all = describe::composed({}, x...);
    describe::token& last = all.tokens[sizeof(all.tokens) / sizeof(describe::token) - 1];
    if (last.what == describe::token_kind::misused) return all;
    last.what = describe::token_kind::external;
    last.index = 0;
    last.external =
        &describe::external_of<describe::external_family<called, count, Function, Derivatives...>>;
    last.is_of_one_file = !is_known_to_all_files<external>;
    return all;
  }

  /// Calls the function with expressions of a builder.
  template <std::same_as<symbolic::expression>... Operands>
    requires(sizeof...(Operands) > 0)
  constexpr auto operator()(Operands... x) const {
    using family =
        describe::external_family<called, static_cast<int>(sizeof...(Operands)), Function, Derivatives...>;
    static_assert(family::mistake.numbers.empty(),
                  "the function or one of its derivatives takes or returns numbers that are not double");
    static_assert(!family::mistake.numbers.empty() || family::mistake.whose.empty(),
                  "the function cannot be called with this number of arguments");
    return call(*describe::external_of<family>.function, {x...});
  }
};

} // namespace kanexpr
