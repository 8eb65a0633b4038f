#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/gap.hpp>
#include <kanexpr/compiled/place.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/vector_checks.hpp>
#include <kanexpr/lower/scalar_math.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <type_traits>

namespace kanexpr::compiled {

/// The common part of the vectors of a system: fixed-size Eigen vectors with access by name, `x[q1]`,
/// constructed from numbers, from any Eigen vector, or by name, `{{q1, 0.1}, {u1, 2}}`. Assignments first
/// convert to this type; if Eigen's own assignments were also available, `x = {0.1, 2}` would be ambiguous.
///
/// A list of names must contain a value for every symbol except the dependent ones, which the constraints
/// determine, and state variables; these are set to zero here. An entry without a value, or with two values,
/// is NaN, and `mistake()` reports the cause.
template <class System, symbols_of which, class Scalar>
class value_vector : public Eigen::Matrix<Scalar, range_of(which, survey_of<System>).size, 1> {
public:
  using matrix = Eigen::Matrix<Scalar, range_of(which, survey_of<System>).size, 1>;
  using matrix::operator[];

  /// A state is initialized to zero; unset parameters and inputs are NaN.
  value_vector() {
    derivation::report_in_code<surveyed<System>>();
    fill(from(which == symbols_of::state ? 0 : number_for(gap::never_set)));
  }

  value_vector(std::initializer_list<entry<System, which, Scalar>> named) { read(named); }

  template <class Derived>
  value_vector(const Eigen::EigenBase<Derived>& other) {
    if constexpr (fits<Derived>()) matrix::operator=(other.derived());
  }

  /// The state of a different system converts to this one, but parameters do not convert to a state.
  template <class Other, symbols_of given, class OtherScalar>
    requires(given != which)
  value_vector(const value_vector<Other, given, OtherScalar>&) {
    static_cast<void>(mismatched_vector<System, which, Other, given>::possible);
  }

  /// Constructs the vector from all its numbers, in order.
  template <class First, class... More>
    requires(std::convertible_to<First, Scalar> && (std::convertible_to<More, Scalar> && ...))
  explicit(sizeof...(More) == 0) value_vector(const First& first, const More&... more) {
    if constexpr (size_check<System, which, 1 + static_cast<int>(sizeof...(More))>::possible) {
      int i = 0;
      (*this)(i) = static_cast<Scalar>(first);
      (((*this)(++i) = static_cast<Scalar>(more)), ...);
    }
  }
  /// Constructs the vector from Eigen's column syntax, `{{1, 2, 3}}`.
  template <std::size_t given>
  value_vector(const Scalar (&column)[given]) {
    if constexpr (size_check<System, which, static_cast<int>(given)>::possible)
      std::copy_n(column, given, this->data());
  }
  explicit value_vector(const Scalar* entries) { std::copy_n(entries, range.size, this->data()); }

  template <describe::expression_of_a_model Symbol>
  Scalar& operator[](const Symbol&) {
    return (*this)(place_in<System, which, Symbol>::place);
  }
  template <describe::expression_of_a_model Symbol>
  const Scalar& operator[](const Symbol&) const {
    return (*this)(place_in<System, which, Symbol>::place);
  }

  /// Returns a message that names the first entry without a finite value; empty if there is none.
  base::sentence mistake() const { return first_gap(*this, survey_of<System>, range, type_name<System>()); }

private:
  static constexpr symbol_range range = range_of(which, survey_of<System>);
  static_assert(sizeof(scalar_check<System, Scalar>) != 0);

  static Scalar from(double value) { return lower::scalar_math<Scalar>::from(value); }

  /// Uses plain loops, like the rest of the library, because the compiler would otherwise instantiate Eigen's
  /// vector functions for each system.
  void fill(const Scalar& value) { std::fill_n(this->data(), range.size, value); }

  template <class Derived>
  static constexpr bool fits() {
    if constexpr (requires { Derived::SizeAtCompileTime; })
      return size_check<System, which, Derived::SizeAtCompileTime>::possible;
    else
      return true;
  }

  static constexpr auto may_be_omitted = [] {
    std::array<bool, static_cast<std::size_t>(range.size) + 1> found{};
    for (int i = 0; i < range.size; ++i)
      found[static_cast<std::size_t>(i)] = survey_of<System>.may_be_omitted(range.first + i);
    return found;
  }();

  void read(std::initializer_list<entry<System, which, Scalar>> named) {
    std::array<bool, static_cast<std::size_t>(range.size) + 1> set{};
    const entry<System, which, Scalar>* unknown = nullptr;
    for (int i = 0; i < range.size; ++i)
      (*this)(i) = may_be_omitted[static_cast<std::size_t>(i)] ? from(0) : from(number_for(gap::never_set));
    for (const auto& given : named) {
      if (given.place < 0) {
        if (unknown == nullptr) unknown = &given;
        continue;
      }
      bool& again = set[static_cast<std::size_t>(given.place)];
      (*this)(given.place) = again ? from(number_for(gap::set_twice)) : given.value;
      again = true;
    }
    if (unknown != nullptr) fill(from(number_for_unknown(unknown->name)));
  }
};

/// Identifies the system that an argument belongs to and the kind of vector; other Eigen vectors do not
/// belong to a system.
template <class Of, symbols_of vector>
struct vector_owner {
  template <class System, symbols_of wanted>
  static constexpr bool fits = vector == wanted && std::is_same_v<Of, System>;
  template <class System, symbols_of wanted>
  static constexpr base::sentence mistake(std::string_view caller) {
    return check_vector_kind<System, wanted, Of, vector>(caller);
  }
};
struct no_owner {
  template <class System, symbols_of wanted>
  static constexpr bool fits = true;
};
template <class Of, symbols_of vector, class Scalar>
vector_owner<Of, vector> vector_owner_of(const value_vector<Of, vector, Scalar>*);
no_owner vector_owner_of(const void*);

/// Whether an argument can serve as the given vector of a system.
template <class System, symbols_of which, class Given>
inline constexpr bool can_be_vector =
    decltype(vector_owner_of(static_cast<const Given*>(nullptr)))::template fits<System, which>;

} // namespace kanexpr::compiled
