#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <cstddef>
#include <cstdint>
#include <map>

namespace kanexpr {

/// How often each number came, for those that are whole or few: how many events there were, how a run ended.
class value_counts {
public:
  static constexpr std::size_t most_values = 1000;

  void take(double number) {
    if (numeric::is_nan(number))
      ++missing_;
    else if (const auto found = counts_.find(number); found != counts_.end())
      ++found->second;
    else if (counts_.size() < most_values)
      counts_.emplace(number, 1);
    else
      ++others_;
  }

  std::uint64_t count(double number) const {
    const auto found = counts_.find(number);
    return found == counts_.end() ? 0 : found->second;
  }
  const std::map<double, std::uint64_t>& counts() const { return counts_; }
  std::uint64_t others() const { return others_; }   ///< of numbers behind the first `most_values` ones
  std::uint64_t missing() const { return missing_; } ///< how many were not numbers

  void write(bytes_writer& out) const {
    out.put(counts_.size());
    for (const auto& [number, count] : counts_) out.put(number), out.put(count);
    out.put(others_), out.put(missing_);
  }
  void read(bytes_reader& in) {
    counts_.clear();
    for (auto left = in.get<std::size_t>(); left > 0 && in; --left) {
      const auto number = in.get<double>();
      counts_[number] = in.get<std::uint64_t>();
    }
    others_ = in.get<std::uint64_t>(), missing_ = in.get<std::uint64_t>();
  }

private:
  std::map<double, std::uint64_t> counts_{};
  std::uint64_t others_ = 0, missing_ = 0;
};

} // namespace kanexpr
