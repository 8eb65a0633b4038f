#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/call.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/units_library.hpp>
#include <kanexpr/compiled/values_reader.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <concepts>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace kanexpr {

/// A symbol or its name, with a value: `{q1, 0.1}`, `{"m", 2.5}`. With a symbol that states its unit, the
/// value may be a quantity of a units library: `{m, 2 * kg}`.
struct named_value {
  symbol_name what;
  double value;

  named_value(symbol_name of, double number) : what(std::move(of)), value(number) {}
  template <class Symbol, compiled::quantity_of_a_library Quantity>
  named_value(const Symbol& of, const Quantity& quantity)
      : what(of), value(compiled::number_of<void, Symbol>(quantity)) {}
};

namespace compiled {

/// The type of an entry in a list such as `std::vector<named_value>` or in a `std::map` from names to
/// numbers.
template <class Entry>
concept names_a_number = std::convertible_to<const Entry&, named_value> || requires(const Entry& entry) {
  { entry.first } -> std::convertible_to<symbol_name>;
  { entry.second } -> std::convertible_to<double>;
};

template <class List>
concept list_of_named_values = requires(const List& list) {
  { *std::begin(list) } -> names_a_number;
};

/// Values for a vector of a system, specified by name or as a vector of numbers.
template <class System, symbols_of which, class Vector, bool may_be_incomplete>
struct given_values {
  Vector values{};
  /// The entries without a value, which the constraints determine.
  std::array<bool, static_cast<std::size_t>(range_of(which, survey_of<System>).size)> is_left_out{};
  base::sentence mistake{}; ///< the first mistake in the values, as a sentence; empty if there is none

  given_values() { read(std::initializer_list<named_value>{}); }
  given_values(std::initializer_list<named_value> list) { read(list); }
  template <list_of_named_values List>
  given_values(const List& list) {
    read(list);
  }
  template <class Derived>
  given_values(const Eigen::MatrixBase<Derived>& numbers) {
    if constexpr (size_check<System, which, Derived::SizeAtCompileTime>::possible) {
      mistake = check_size(range.vector, type_name<System>(), static_cast<int>(numbers.size()), range.size);
      if (mistake) return;
      values = numbers;
      values_reader reader = reads();
      reader.check_finite();
      reader.check_physical();
      mistake = reader.mistake();
    }
  }
  template <class Other, symbols_of given, class Scalar>
    requires(given != which || !std::same_as<Other, System>)
  given_values(const value_vector<Other, given, Scalar>&) {
    static_cast<void>(mismatched_vector<System, which, Other, given>::possible);
  }

private:
  static constexpr symbol_range range = range_of(which, survey_of<System>);

  static constexpr describe::system_record told = [] {
    if constexpr (requires { System::record; })
      return System::record;
    else
      return describe::system_record{};
  }();

  values_reader reads() { return {survey_of<System>, told, type_name<System>(), range, values.data()}; }

  template <class List>
  void read(const List& list) {
    std::fill_n(values.data(), range.size, 0.0); // the entries that may be omitted
    values_reader reader = reads();
    for (const auto& entry : list)
      if constexpr (requires { entry.first; })
        reader.read(entry.first, static_cast<double>(entry.second));
      else
        read_one(reader, entry);
    if constexpr (!may_be_incomplete) reader.check_missing();
    reader.check_finite();
    reader.check_physical();
    for (int i = 0; i < range.size; ++i) is_left_out[static_cast<std::size_t>(i)] = !reader.is_named(i);
    mistake = reader.mistake();
  }
  static void read_one(values_reader& reader, const named_value& entry) {
    reader.read(entry.what, entry.value);
  }
};

} // namespace compiled

/// A state specified as `{{q1, 0.1}, {u1, 0}}`, as any list of names and values, or as an Eigen vector.
/// Dependent coordinates and speeds may be omitted; they are zero here, and the constraints determine them.
/// State variables may be omitted, too; they start at zero.
template <class System>
struct given_state
    : compiled::given_values<System, compiled::symbols_of::state, kanexpr::state<System>, false> {
  using given_state::given_values::given_values;
};

/// Parameters specified by name, as in `{{m, 2}, {"l", 0.5}}`, or as an Eigen vector.
template <class System>
struct given_parameters
    : compiled::given_values<System, compiled::symbols_of::parameters, parameter_values<System>, false> {
  using given_parameters::given_values::given_values;
};

/// Inputs specified by name, as in `{{T, 2}, {dot(theta), 1}}`, or as an Eigen vector.
template <class System>
struct given_inputs
    : compiled::given_values<System, compiled::symbols_of::inputs, input_values<System>, false> {
  using given_inputs::given_values::given_values;
};

/// The initial guess for a state or for inputs that a search determines; omitted entries start at zero.
template <class System>
struct guessed_state
    : compiled::given_values<System, compiled::symbols_of::state, kanexpr::state<System>, true> {
  using guessed_state::given_values::given_values;
};
/// The initial guess for inputs that a search determines; omitted entries start at zero.
template <class System>
struct guessed_inputs
    : compiled::given_values<System, compiled::symbols_of::inputs, input_values<System>, true> {
  using guessed_inputs::given_values::given_values;
};

} // namespace kanexpr
