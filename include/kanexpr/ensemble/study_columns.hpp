#pragma once

#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/derive/survey.hpp>
#include <kanexpr/ensemble/finished_run.hpp>
#include <kanexpr/ensemble/layout.hpp>
#include <kanexpr/ensemble/run_values.hpp>
#include <kanexpr/ensemble/runs.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// The unit of what a symbol or a factor says, for the columns of tables: `{q1, "rad"}`.
struct unit_of {
  varied_name what;
  std::string unit;
};

namespace ensembles {

/// Columns of one name, or without one.
inline std::string mistake_in(const std::vector<column_label>& columns) {
  table names;
  for (const column_label& each : columns)
    if (const outcome added = names.add(each.name, {}); !added)
      return "of what the study keeps, " + added.cause();
  return {};
}

/// The columns of a study, with their units.
class study_columns {
public:
  study_columns(const deriving::survey& known, const std::vector<unit_of>& units)
      : known_(known), units_(units) {}

  /// The number of a run, how it ended, when, what it was given, what is kept of it.
  std::vector<column_label> of_runs(const runs& given, std::span<const column_label> kept) const {
    std::vector<column_label> all;
    for (std::string name : {"run", "end", "t_end"}) {
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

  /// Of a study, as it is told.
  template <class Study>
  static study_layout layout_of(const Study& told, const deriving::survey& known, std::string_view system) {
    const study_columns columns(known, told.units);
    std::vector<column_label> kept;
    for (const auto& each : told.keep) {
      kept.push_back(each.what);
      if (kept.back().unit.empty() && !each.symbol.empty()) kept.back().unit = columns.unit(each.symbol);
    }
    study_layout found;
    found.study = told.name.empty() ? std::string(system) : told.name;
    found.runs = told.runs.size();
    found.columns = columns.of_runs(told.runs, kept);
    found.varied = told.runs.varied().size();
    for (const auto* list : {&told.state, &told.parameters, &told.inputs})
      for (const auto& each : *list)
        found.constants.push_back({{each.what.name(), columns.unit(each.what.name())}, each.value});
    found.state = columns.of_state();
    if (told.keep_end_state)
      for (const column_label& each : found.state) found.columns.push_back({each.name + "_end", each.unit});
    if (told.keep_trajectories) found.samples = columns.of_samples();
    return found;
  }

  /// A row of the table before its run, in which nothing else is a number yet.
  static std::vector<double> row_of(const study_layout& layout, std::size_t run) {
    std::vector<double> row(layout.columns.size(), std::numeric_limits<double>::quiet_NaN());
    row[0] = static_cast<double>(run);
    return row;
  }
  /// What the run is given.
  static void begin(finished_run& done, const run_values& given) {
    std::copy(given.all().begin(), given.all().end(), done.values.begin() + own);
  }
  /// After it, in the state where it ended: what was kept goes where the run failed.
  template <class Study>
  static void complete(const Study& told, const study_layout& layout, finished_run& done) {
    done.values[1] = static_cast<double>(done.end), done.values[2] = done.time;
    double* kept = kept_in(layout, done);
    if (done.end == run_end::failed) {
      std::fill(kept, done.values.data() + done.values.size(), std::numeric_limits<double>::quiet_NaN());
    } else {
      if (told.keep_end_state) std::copy(done.state.begin(), done.state.end(), kept + told.keep.size());
      done.state.clear();
    }
  }
  /// Where in a row the numbers are that are kept.
  static double* kept_in(const study_layout& layout, finished_run& done) {
    return done.values.data() + own + layout.varied;
  }

private:
  static constexpr std::size_t own = 3; ///< columns that every study has

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

} // namespace ensembles

} // namespace kanexpr
