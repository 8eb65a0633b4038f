#pragma once

#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/derive/survey.hpp>
#include <kanexpr/ensemble/layout.hpp>
#include <kanexpr/ensemble/study.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::ensembles {

/// The columns of a study, with their units.
class study_columns {
public:
  study_columns(const deriving::survey& known, const std::vector<unit_of>& units)
      : known_(known), units_(units) {}

  /// The number of a run, how it ended, when, what it was given, what is kept of it.
  std::vector<column_label> of_runs(const runs& given, std::span<const column_label> kept) const {
    std::vector<column_label> all;
    for (const char* own : {"run", "end", "t_end"}) {
      std::string name = own;
      while (is_varied(given, name)) name += '_';
      all.push_back({name, all.size() == 2 ? "s" : ""});
    }
    for (const varied_name& each : given.varied()) all.push_back({each.name(), unit(each.name())});
    all.insert(all.end(), kept.begin(), kept.end());
    return all;
  }

  std::vector<column_label> of_state() const { return of_symbols(0, known_.coordinates + known_.speeds); }

  /// As those of a trajectory's table.
  std::vector<column_label> of_samples() const {
    std::vector<column_label> all{
        {simulated::name_of_time([&](const std::string& name) {
           return std::ranges::any_of(known_.names, [&](const auto& other) { return other.view() == name; });
         }),
         "s"}};
    for (const column_label& each : of_state()) all.push_back(each);
    for (const column_label& each : of_symbols(known_.first_of(symbolic::symbol_kind::input), known_.inputs))
      all.push_back(each);
    return all;
  }

private:
  static bool is_varied(const runs& given, const std::string& name) {
    return std::ranges::any_of(given.varied(), [&](const varied_name& each) { return each.name() == name; });
  }
  std::vector<column_label> of_symbols(int first, int count) const {
    std::vector<column_label> all;
    for (int i = first; i < first + count; ++i) {
      const std::string name(known_.names[i].view());
      all.push_back({name, unit(name)});
    }
    return all;
  }
  std::string unit(std::string_view name) const {
    for (const unit_of& each : units_)
      if (each.what.name() == name) return each.unit;
    return {};
  }

  const deriving::survey& known_;
  const std::vector<unit_of>& units_;
};

} // namespace kanexpr::ensembles
