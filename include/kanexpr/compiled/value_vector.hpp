#pragma once

#include <kanexpr/compiled/entry.hpp>
#include <kanexpr/compiled/fitting.hpp>
#include <kanexpr/compiled/gap.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace kanexpr::compiled {

/// What the vectors of a system have in common: fixed-size Eigen vectors with access by name, `x[q1]`, which
/// are made of numbers, of any Eigen vector or by name, `{{q1, 0.1}, {u1, 2}}`. What is assigned becomes one
/// first: with Eigen's assignments beside it, `x = {0.1, 2}` could mean two things.
///
/// In a list of names every symbol needs a value, but for the dependent ones, which the constraints give and
/// which are zero here. What has none, or two, is not a number, and `mistake()` says why.
template <class System, symbols_of which, class Scalar>
class value_vector : public Eigen::Matrix<Scalar, range_of(which, survey_of<System>).size, 1> {
public:
  using base = Eigen::Matrix<Scalar, range_of(which, survey_of<System>).size, 1>;
  using base::operator[];

  /// A state is zero; parameters and inputs are not numbers until they are set.
  value_vector() {
    deriving::tell_in_code<surveyed<System>>();
    fill(from(which == symbols_of::state ? 0 : number_for(gap::never_set)));
  }

  value_vector(std::initializer_list<entry<System, which, Scalar>> named) { read(named); }

  template <class Derived>
  value_vector(const Eigen::EigenBase<Derived>& other) {
    if constexpr (fits<Derived>()) base::operator=(other.derived());
  }

  /// The state of another system may become this one's, but no parameters a state.
  template <class Other, symbols_of given, class OtherScalar>
    requires(given != which)
  value_vector(const value_vector<Other, given, OtherScalar>&) {
    static_cast<void>(exchanged<System, which, Other, given>::possible);
  }

  /// All numbers in their order.
  template <class First, class... More>
    requires(std::convertible_to<First, Scalar> && (std::convertible_to<More, Scalar> && ...))
  explicit(sizeof...(More) == 0) value_vector(const First& first, const More&... more) {
    if constexpr (fitting<System, which, 1 + static_cast<int>(sizeof...(More))>::possible) {
      int i = 0;
      (*this)(i) = static_cast<Scalar>(first);
      (((*this)(++i) = static_cast<Scalar>(more)), ...);
    }
  }
  /// The same as Eigen takes columns, `{{1, 2, 3}}`.
  template <std::size_t given>
  value_vector(const Scalar (&column)[given]) {
    if constexpr (fitting<System, which, static_cast<int>(given)>::possible)
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

  /// The first entry that has no finite value, as a sentence; empty: there is none.
  mechanics::sentence mistake() const {
    return first_gap(*this, survey_of<System>, range, type_name<System>());
  }

private:
  static constexpr symbol_range range = range_of(which, survey_of<System>);
  static_assert(sizeof(holding<System, Scalar>) != 0);

  static Scalar from(double value) { return lower::scalar_math<Scalar>::from(value); }

  /// In plain loops, as everywhere here: Eigen's functions of vectors are new to the compiler for each
  /// system.
  void fill(const Scalar& value) { std::fill_n(this->data(), range.size, value); }

  template <class Derived>
  static constexpr bool fits() {
    if constexpr (requires { Derived::SizeAtCompileTime; })
      return fitting<System, which, Derived::SizeAtCompileTime>::possible;
    else
      return true;
  }

  static constexpr auto dependent = [] {
    std::array<bool, static_cast<std::size_t>(range.size) + 1> found{};
    for (int i = 0; i < range.size; ++i)
      found[static_cast<std::size_t>(i)] = survey_of<System>.dependent[range.first + i];
    return found;
  }();

  void read(std::initializer_list<entry<System, which, Scalar>> named) {
    std::array<bool, static_cast<std::size_t>(range.size) + 1> set{};
    const entry<System, which, Scalar>* unknown = nullptr;
    for (int i = 0; i < range.size; ++i)
      (*this)(i) = dependent[static_cast<std::size_t>(i)] ? from(0) : from(number_for(gap::never_set));
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

/// Which vector of which system an argument is; any other Eigen vector is none.
template <class Of, symbols_of vector>
struct belonging {
  template <class System, symbols_of wanted>
  static constexpr bool fits = vector == wanted && std::is_same_v<Of, System>;
  template <class System, symbols_of wanted>
  static constexpr mechanics::sentence mistake(std::string_view caller) {
    return check_exchanged<System, wanted, Of, vector>(caller);
  }
};
struct belonging_to_none {
  template <class System, symbols_of wanted>
  static constexpr bool fits = true;
};
template <class Of, symbols_of vector, class Scalar>
belonging<Of, vector> belonging_of(const value_vector<Of, vector, Scalar>*);
belonging_to_none belonging_of(const void*);

} // namespace kanexpr::compiled
