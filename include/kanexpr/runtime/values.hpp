#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/runtime/model.hpp>

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr {

namespace runtime {

using compiled::symbols_of;

/// The name of a model in messages about values; empty, because the type `model` does not identify the
/// system.
inline constexpr std::string_view name_of_models = {};

/// A vector of a run-time model: an Eigen vector with access by name, `x["q1"]`. A vector that was not
/// constructed from a model has no names.
class value_vector : public Eigen::VectorXd {
public:
  using Eigen::VectorXd::operator[];

  value_vector() = default;
  value_vector(std::shared_ptr<const derivation::survey> known, symbols_of which)
      : known_(std::move(known)), which_(which) {
    setConstant(range().size, which == symbols_of::state ? 0 : number_for(compiled::gap::never_set));
  }
  template <class Derived>
  value_vector(const Eigen::EigenBase<Derived>& numbers) : Eigen::VectorXd(numbers) {}
  value_vector(const value_vector&) = default;
  value_vector(value_vector&&) = default;
  ~value_vector() = default;

  /// Assigns the numbers; assigns the names only if the vector has none.
  value_vector& operator=(const value_vector& other) {
    Eigen::VectorXd::operator=(other);
    unknown_ = other.unknown_;
    if (known_ == nullptr) known_ = other.known_, which_ = other.which_;
    return *this;
  }
  template <class Derived>
  value_vector& operator=(const Eigen::EigenBase<Derived>& numbers) {
    Eigen::VectorXd::operator=(numbers);
    return *this;
  }

  /// The value of a symbol. If the model has no symbol with that name, the value is NaN, assignments are
  /// ignored, and `mistake` reports the name.
  double& operator[](std::string_view name) {
    const int i = index(name);
    return i >= 0 ? (*this)(i) : unknown_value_ = not_a_number;
  }
  double operator[](std::string_view name) const {
    const int i = index(name);
    return i >= 0 ? (*this)(i) : not_a_number;
  }

  bool holds(std::string_view name) const { return find(name) >= 0; }

  /// Returns a message about the last unknown name that was looked up; empty if there was none.
  base::sentence mistake() const {
    if (unknown_.empty()) return {};
    return base::sentence({"the model has no ", range().symbol, " ", unknown_});
  }

  /// The symbols of the model; null if the vector was not constructed from one.
  const std::shared_ptr<const derivation::survey>& known() const { return known_; }

private:
  static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

  compiled::symbol_range range() const {
    return known_ != nullptr ? compiled::range_of(which_, *known_)
                             : compiled::symbol_range{0, 0, "value", "symbol"};
  }

  int find(std::string_view name) const {
    const compiled::symbol_range among = range();
    for (int i = 0; i < among.size && i < size(); ++i)
      if (known_->names[among.first + i].view() == name) return i;
    return -1;
  }
  int index(std::string_view name) const {
    const int found = find(name);
    if (found < 0) unknown_ = name;
    return found;
  }

  std::shared_ptr<const derivation::survey> known_{};
  symbols_of which_ = symbols_of::state;
  mutable std::string unknown_{};
  double unknown_value_ = not_a_number; ///< receives assignments to unknown symbols
};

/// Values for a vector of a model, specified by name or as a vector of numbers. They are assigned to symbols
/// once the model is known.
template <symbols_of which, class Vector>
class given_values {
public:
  given_values() = default;
  given_values(std::initializer_list<named_value> list) : named_(list) {}
  template <compiled::list_of_named_values List>
  given_values(const List& list) {
    for (const auto& entry : list)
      if constexpr (requires { entry.first; })
        named_.push_back({entry.first, static_cast<double>(entry.second)});
      else
        named_.push_back(entry);
  }
  template <class Derived>
  given_values(const Eigen::MatrixBase<Derived>& numbers) : numbers_(numbers) {}

  Vector values{};
  std::vector<bool> is_left_out{}; ///< symbols without a value, which the constraints determine
  base::sentence mistake{};        ///< the first mistake in the values, as a sentence; empty if there is none

  /// Assigns the values to the symbols of a model. Omitted values are zero, and a mistake if `requires_all`,
  /// except those that the constraints determine.
  void read(const std::shared_ptr<const derivation::survey>& known, bool requires_all = true) {
    const compiled::symbol_range range = compiled::range_of(which, *known);
    static constexpr describe::system_record nothing_bound{};
    values = Vector(value_vector(known, which));
    compiled::values_reader reader(*known, nothing_bound, name_of_models, range, values.data());
    is_left_out.assign(static_cast<std::size_t>(range.size), false);
    if (numbers_) {
      mistake =
          compiled::check_size(range.vector, "the model", static_cast<int>(numbers_->size()), range.size);
      if (mistake) return;
      values = *numbers_;
    } else {
      values.setZero(); // the default for omitted values
      for (const named_value& each : named_) reader.read(each.what, each.value);
      if (requires_all) reader.check_missing();
      for (int i = 0; i < range.size; ++i) is_left_out[static_cast<std::size_t>(i)] = !reader.is_named(i);
    }
    reader.check_finite();
    reader.check_physical();
    mistake = reader.mistake();
  }

private:
  std::vector<named_value> named_{};
  std::optional<Eigen::VectorXd> numbers_{};
};

/// The state, parameters or inputs of a model.
template <symbols_of which>
class values_of_model : public value_vector {
public:
  values_of_model() = default;
  explicit values_of_model(const model& of) : value_vector(of.known(), which) {}
  explicit values_of_model(value_vector&& values) : value_vector(std::move(values)) {}
  template <class Derived>
  values_of_model(const Eigen::EigenBase<Derived>& numbers) : value_vector(numbers) {}
  using value_vector::operator=;
};

} // namespace runtime

/// The state [q; u; z] of a model, where z are the state variables; initially zero.
template <>
class state<model> : public runtime::values_of_model<compiled::symbols_of::state> {
public:
  using values_of_model::values_of_model;
  using values_of_model::operator=;

  auto q() { return head(known()->coordinates); }
  auto q() const { return head(known()->coordinates); }
  auto u() { return segment(known()->coordinates, speeds()); }
  auto u() const { return segment(known()->coordinates, speeds()); }
  auto z() { return tail(known()->state_variables); }
  auto z() const { return tail(known()->state_variables); }

private:
  int speeds() const { return known()->speeds - known()->state_variables; }
};

/// The parameters of a model, NaN until they are set.
template <>
class parameter_values<model> : public runtime::values_of_model<compiled::symbols_of::parameters> {
public:
  using values_of_model::values_of_model;
  using values_of_model::operator=;
};

/// The inputs of a model, NaN until they are set. The rate of a prescribed quantity theta is called "theta'".
template <>
class input_values<model> : public runtime::values_of_model<compiled::symbols_of::inputs> {
public:
  using values_of_model::values_of_model;
  using values_of_model::operator=;
};

template <>
struct given_state<model> : runtime::given_values<compiled::symbols_of::state, state<model>> {
  using given_values::given_values;
};
template <>
struct given_parameters<model>
    : runtime::given_values<compiled::symbols_of::parameters, parameter_values<model>> {
  using given_values::given_values;
};
template <>
struct given_inputs<model> : runtime::given_values<compiled::symbols_of::inputs, input_values<model>> {
  using given_values::given_values;
};

} // namespace kanexpr
