#pragma once

#include <kanexpr/numeric/powers_of_two.hpp>

#include <cstddef>
#include <cstdint>
#include <map>

namespace kanexpr {

/// The frequency of each value of a quantity with few values: the number of events, or how a run ended.
class value_counts {
public:
  static constexpr std::size_t max_values = 1000;

  void take(double number) {
    if (numeric::is_nan(number))
      ++missing_;
    else if (const auto found = counts_.find(number); found != counts_.end())
      ++found->second;
    else if (counts_.size() < max_values)
      counts_.emplace(number, 1);
    else
      ++others_;
  }

  std::uint64_t count(double number) const {
    const auto found = counts_.find(number);
    return found == counts_.end() ? 0 : found->second;
  }
  const std::map<double, std::uint64_t>& counts() const { return counts_; }
  std::uint64_t others() const { return others_; }   ///< values after the first `max_values` ones
  std::uint64_t missing() const { return missing_; } ///< the number of NaN

  static void fields(auto& self, auto& archive) { archive(self.counts_, self.others_, self.missing_); }

private:
  std::map<double, std::uint64_t> counts_{};
  std::uint64_t others_ = 0, missing_ = 0;
};

} // namespace kanexpr
