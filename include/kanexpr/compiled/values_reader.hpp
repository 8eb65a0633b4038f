#pragma once

#include <kanexpr/compiled/gap.hpp>
#include <kanexpr/derive/read/wording.hpp>
#include <kanexpr/derive/survey.hpp>
#include <kanexpr/describe/symbol_name.hpp>
#include <kanexpr/describe/system.hpp>

#include <array>

namespace kanexpr::compiled {

/// Puts values that are given by name into their places, and keeps the first mistake. A model that was
/// derived while the program runs has no name: "the model has no parameter ll".
class values_reader {
public:
  values_reader(const deriving::survey& known, const describe::system_record& told, std::string_view system,
                const symbol_range& range, double* values)
      : known_(known), told_(told), system_(system), range_(range), values_(values) {}

  void read(const symbol_name& what, double value) {
    const int place = place_of(what.name());
    if (range_.holds(place)) {
      const auto i = static_cast<std::size_t>(place - range_.first);
      if (named_[i]) fail({symbol_called(known_, place).view(), " has two values"});
      named_[i] = true;
      values_[i] = value;
    } else if (what.name().empty()) {
      fail({"a value is given to something that is not a symbol"});
    } else if (place >= 0) {
      fail({symbol_called(known_, place).view(), " has no place in the ", range_.vector, " vector of ",
            system_.empty() ? "the model" : system_});
    } else if (is_bound(what.name())) {
      fail({"parameter ", what.name(), " has its value in the system ", system_});
    } else {
      fail({system_.empty() ? "the model" : "the system ", system_, " has no ", range_.symbol, " ",
            what.name()});
    }
  }

  /// Every symbol needs a value except the dependent ones, which the constraints give.
  void look_for_missing() {
    for (int i = 0; i < range_.size; ++i)
      if (!named_[static_cast<std::size_t>(i)] && !known_.dependent[range_.first + i])
        fail({symbol_called(known_, range_.first + i).view(), " has no value"});
  }

  void look_for_infinite() {
    for (int i = 0; i < range_.size && !mistake_; ++i)
      mistake_ = told_of(gap_in(values_[i]), known_, range_.first + i, system_);
  }

  const mechanics::sentence& mistake() const { return mistake_; }

private:
  int place_of(std::string_view name) const {
    for (int place = 0; place < known_.symbols(); ++place)
      if (known_.names[place].view() == name) return place;
    return -1;
  }

  bool is_bound(std::string_view name) const {
    for (int i = 0; i < told_.values.size; ++i)
      if (deriving::name_in(told_.values[i]) == name) return true;
    return false;
  }

  void fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake_) mistake_ = mechanics::sentence(pieces);
  }

  const deriving::survey& known_;
  const describe::system_record& told_;
  std::string_view system_;
  symbol_range range_;
  double* values_;
  std::array<bool, deriving::survey::room> named_{};
  mechanics::sentence mistake_{};
};

} // namespace kanexpr::compiled
