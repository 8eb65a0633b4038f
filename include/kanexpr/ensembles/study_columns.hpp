#pragma once

#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/units_of.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/derivation/unit_labels.hpp>
#include <kanexpr/ensembles/study.hpp>
#include <kanexpr/ensembles/study_interface.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::ensembles {

/// The index of a symbol of a system; -1 if there is no symbol of this name.
template <class System>
int symbol_index(std::string_view name) {
  constexpr const derivation::survey& known = compiled::survey_of<System>;
  for (int i = 0; i < known.symbols(); ++i)
    if (known.names[i].view() == name) return i;
  return -1;
}

/// Determines the columns of a study, with their units: those of the study, or else those of the model.
template <class Kind>
class study_columns {
  using System = typename Kind::System;
  using labels = std::vector<column_label>;
  static constexpr const derivation::survey& known = compiled::survey_of<System>;
  static constexpr int states = known.coordinates + known.speeds;

public:
  static study_layout layout_of(const study_of<Kind>& study) {
    const study_columns columns{study.units};
    study_layout all;
    all.study = study.name.empty() ? std::string(type_name<System>()) : study.name;
    all.runs = study.runs.size();
    all.varied = study.runs.varied().size();
    for (const auto* list : {&study.state, &study.parameters, &study.inputs})
      for (const auto& each : *list) all.constants.push_back({columns.label(each.what.name()), each.value});
    all.state = columns.symbols(0, states);
    if (study.keep_trajectories) all.samples = columns.samples();
    all.columns = columns.runs(study, all.state);
    return all;
  }

private:
  explicit study_columns(const std::vector<unit_of>& units) : units_(units) {}

  labels runs(const study_of<Kind>& study, const labels& state) const {
    labels all;
    for (std::string name : {"run", "end", "t_end"}) {
      while (study.runs.varies(name)) name += '_';
      all.push_back({name, all.size() == 2 ? "s" : ""});
    }
    for (const varied_name& each : study.runs.varied()) all.push_back(label(each.name()));
    for (const auto& each : study.keep) {
      all.push_back(each.what);
      if (each.what.unit.empty()) all.back().unit = label(each.symbol).unit;
    }
    if (study.keep_end_state)
      for (const column_label& each : state) all.push_back({each.name + "_end", each.unit});
    return all;
  }
  labels samples() const {
    labels all{
        {base::name_of_time([](const std::string& name) { return symbol_index<System>(name) >= 0; }), "s"}};
    for (const labels& each :
         {symbols(0, states), symbols(known.first_of(symbolic::symbol_kind::input), known.inputs)})
      all.insert(all.end(), each.begin(), each.end());
    return all;
  }
  labels symbols(int first, int count) const {
    labels all;
    for (int i = first; i < first + count; ++i) all.push_back(label(std::string(known.names[i].view())));
    return all;
  }
  column_label label(const std::string& name) const {
    for (const unit_of& each : units_)
      if (each.what.name() == name && !name.empty()) return {name, each.unit};
    const int place = symbol_index<System>(name);
    if (place < 0) return {name};
    return {name, derivation::unit_label(compiled::stated_units_of<System>(), known, place)};
  }

  const std::vector<unit_of>& units_;
};

} // namespace kanexpr::ensembles
