#pragma once

#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/ensembles/layout.hpp>
#include <kanexpr/ensembles/runs.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr {

/// The unit of a symbol or factor, for the columns of tables: `{q1, "rad"}`.
struct unit_of {
  varied_name what;
  std::string unit;
};

namespace ensembles {

/// Reports columns that have no name, or the same name.
inline std::string mistake_in(const std::vector<column_label>& columns) {
  table names;
  for (const column_label& each : columns)
    if (const outcome added = names.add(each.name, {}); !added)
      return "in the outputs of the study, " + added.cause();
  return {};
}

/// Determines the columns of a study, with their units.
class study_columns {
public:
  template <class Study>
  static study_layout layout_of(const Study& study, const derivation::survey& known,
                                std::string_view system) {
    const study_columns columns{known, study.units};
    study_layout all;
    all.study = study.name.empty() ? std::string(system) : study.name;
    all.runs = study.runs.size();
    all.varied = study.runs.varied().size();
    for (const auto* list : {&study.state, &study.parameters, &study.inputs})
      for (const auto& each : *list) all.constants.push_back({columns.label(each.what.name()), each.value});
    all.state = columns.symbols(0, known.coordinates + known.speeds);
    if (study.keep_trajectories) all.samples = columns.samples();

    for (std::string name : {"run", "end", "t_end"}) {
      while (study.runs.varies(name)) name += '_';
      all.columns.push_back({name, all.columns.size() == 2 ? "s" : ""});
    }
    for (const varied_name& each : study.runs.varied()) all.columns.push_back(columns.label(each.name()));
    for (const auto& each : study.keep) {
      all.columns.push_back(each.what);
      if (each.what.unit.empty()) all.columns.back().unit = columns.label(each.symbol).unit;
    }
    if (study.keep_end_state)
      for (const column_label& each : all.state) all.columns.push_back({each.name + "_end", each.unit});
    return all;
  }

private:
  study_columns(const derivation::survey& known, const std::vector<unit_of>& units)
      : known_(known), units_(units) {}

  /// The columns of a trajectory's table.
  std::vector<column_label> samples() const {
    const std::string time = base::name_of_time([&](const std::string& name) {
      return std::ranges::any_of(known_.names, [&](const auto& other) { return other.view() == name; });
    });
    std::vector<column_label> all = symbols(0, known_.coordinates + known_.speeds);
    all.insert(all.begin(), {time, "s"});
    const auto inputs = symbols(known_.first_of(symbolic::symbol_kind::input), known_.inputs);
    all.insert(all.end(), inputs.begin(), inputs.end());
    return all;
  }
  std::vector<column_label> symbols(int first, int count) const {
    std::vector<column_label> all;
    for (int i = first; i < first + count; ++i) all.push_back(label(std::string(known_.names[i].view())));
    return all;
  }
  column_label label(const std::string& name) const {
    for (const unit_of& each : units_)
      if (each.what.name() == name && !name.empty()) return {name, each.unit};
    return {name};
  }

  const derivation::survey& known_;
  const std::vector<unit_of>& units_;
};

} // namespace ensembles

} // namespace kanexpr
