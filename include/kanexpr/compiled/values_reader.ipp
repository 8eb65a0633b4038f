#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/gap.hpp>
#include <kanexpr/compiled/values_reader.hpp>
#include <kanexpr/derivation/read/wording.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::compiled {

KANEXPR_ENGINE base::sentence check_masses(const derivation::survey& known, const double* parameters) {
  for (int i = 0; i < known.parameters; ++i)
    if (const int place = known.coordinates + known.speeds + i;
        (known.is_mass[place] || known.is_moment[place]) && numeric::is_finite(parameters[i]) &&
        parameters[i] < 0)
      return base::sentence({symbol_called(known, place).view(),
                             known.is_mass[place] ? ", the mass of a body," : ", a moment of inertia,",
                             " is negative"});
  return known.inertial.count + known.inertial.bounded == 0 ? base::sentence()
                                                            : known.inertial.mistake(parameters);
}

KANEXPR_ENGINE void values_reader::read(const symbol_name& what, double value) {
  const int place = place_of(what.name());
  if (range_.holds(place)) {
    const auto i = static_cast<std::size_t>(place - range_.first);
    if (named_[i]) fail({symbol_called(known_, place).view(), " has two values"});
    named_[i] = true;
    values_[i] = value;
  } else if (what.name().empty()) {
    fail({"a value is assigned to an expression that is not a symbol"});
  } else if (place >= 0) {
    fail({symbol_called(known_, place).view(), " is not an entry of the ", range_.vector, " vector of ",
          system_.empty() ? "the model" : system_});
  } else if (is_bound(what.name())) {
    fail({"parameter ", what.name(), " is already bound in the system ", system_});
  } else {
    fail({system_.empty() ? "the model" : "the system ", system_, " has no ", range_.symbol, " ",
          what.name()});
  }
}

KANEXPR_ENGINE void values_reader::check_missing() {
  for (int i = 0; i < range_.size; ++i)
    if (!named_[static_cast<std::size_t>(i)] && !known_.may_be_omitted(range_.first + i))
      fail({symbol_called(known_, range_.first + i).view(), " has no value"});
}

KANEXPR_ENGINE void values_reader::check_finite() {
  for (int i = 0; i < range_.size && !mistake_; ++i)
    mistake_ = describe_gap(gap_in(values_[i]), known_, range_.first + i, system_);
}

KANEXPR_ENGINE void values_reader::check_physical() {
  if (!mistake_ && range_.first == known_.first_of(symbolic::symbol_kind::parameter))
    mistake_ = check_masses(known_, values_);
}

KANEXPR_ENGINE int values_reader::place_of(std::string_view name) const {
  for (int place = 0; place < known_.symbols(); ++place)
    if (known_.names[place].view() == name) return place;
  return -1;
}

KANEXPR_ENGINE bool values_reader::is_bound(std::string_view name) const {
  for (int i = 0; i < told_.values.size; ++i)
    if (derivation::name_in(told_.values[i]) == name) return true;
  return false;
}

KANEXPR_ENGINE void values_reader::fail(std::initializer_list<std::string_view> pieces) {
  if (!mistake_) mistake_ = base::sentence(pieces);
}

} // namespace kanexpr::compiled
