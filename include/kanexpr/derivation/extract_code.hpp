#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/causes.hpp>
#include <kanexpr/derivation/request.hpp>
#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// The straight-line code for a set of results. The measures and scales of potential singularities follow all
/// other results of the tape, one pair per cause. The arrays are large enough for any model, so programs must
/// not store such an object.
struct extracted_code {
  sentence mistake{};
  large_cause_list causes{};
  lower::roomy_tape tape{};
  bool follows_from_unparsed = false; ///< whether the mistake is caused by a type that did not parse
  bool checks_finiteness = false;     ///< the last pair checks whether the results are finite

  constexpr extracted_code() = default;
  constexpr explicit extracted_code(const sentence& because) : mistake(because) {}
};

/// Reports code that exceeds the capacity of the arrays.
constexpr sentence check_room(std::string_view system, const lower::tape_sizes& sizes) {
  if (lower::has_room_for(sizes)) return {};
  return sentence({"the results requested from ", system, " take ", base::counted(sizes.steps).view(),
                   " operations and have ", base::counted(sizes.results).view(), " entries; the limit is ",
                   base::counted(lower::most_steps).view(), " of each; request them in parts"});
}

template <cause_sizes room>
constexpr sentence check_room(std::string_view system, const cause_list<room>& causes, const sentence& next) {
  if (causes.has_room_for(next)) return {};
  return sentence({"the results requested from ", system,
                   " have more potential singularities than supported; request them in parts"});
}

/// The nodes of all entries of the results, followed by those of the potential singularities on which they
/// depend.
struct needed_nodes {
  sequence<int> nodes{};
  sequence<mechanics::singularity_check> checks{};
};

constexpr needed_nodes nodes_for(derived_system& system, std::span<const request> all) {
  needed_nodes found;
  for (const request& each : all) {
    const symbolic::matrix result = form(each, system.reader(), system.equations());
    for (const expression& entry : result.entries) found.nodes.push(entry.node());
  }
  if (system.mistake()) return found;
  found.checks = system.equations().singularity_checks_of(found.nodes);
  for (const mechanics::singularity_check& g : found.checks) {
    found.nodes.push(g.measure.node());
    found.nodes.push(g.scale.node());
  }
  return found;
}

/// Reports a symbol that a requested expression contains but the system does not, because no argument has an
/// entry for it.
constexpr sentence check_symbols(std::string_view system, const survey& known, const mechanism& m) {
  struct list {
    std::string_view kind;
    const sequence<expression>& symbols;
    int known;
  };
  for (const list& l :
       {list{"parameter", m.parameters, known.parameters}, list{"input", m.inputs, known.inputs}})
    if (l.symbols.size() > l.known) {
      const std::string_view called = m.g->symbol_at(l.symbols[l.known].node()).called.view();
      return sentence({l.kind, " ", called, ", which an expression contains, is not among those of ", system,
                       "; write used_elsewhere<", called, ">"});
    }
  return {};
}

/// Extracts the code for the requested results from a derivation.
constexpr extracted_code extract_code(derived_system& system, std::string_view called,
                                      const survey& of_system, std::span<const request> all) {
  const needed_nodes found = nodes_for(system, all);
  if (system.mistake()) return extracted_code(system.mistake());
  if (const sentence added = check_symbols(called, of_system, system.mechanism()))
    return extracted_code(added);
  extracted_code code;
  for (const mechanics::singularity_check& g : found.checks) {
    if (const sentence lacking = check_room(called, code.causes, g.cause)) return extracted_code(lacking);
    code.causes.push(g.cause);
    code.checks_finiteness = g.of_finiteness;
  }
  const auto keep = [&](const auto& tape) {
    if (const sentence lacking = check_room(called, lower::sizes_of(tape)))
      code.mistake = lacking;
    else
      code.tape = lower::fixed(tape);
  };
  if (__builtin_is_constant_evaluated())
    keep(lower::constant_tape_from(system.graph(), found.nodes));
  else
    keep(lower::tape_from(system.graph(), found.nodes));
  return code.mistake ? extracted_code(code.mistake) : code;
}

constexpr stage stage_for(std::span<const request> all) {
  stage furthest = stage::constrained;
  for (const request& each : all)
    if (stage_for(each) > furthest) furthest = stage_for(each);
  return furthest;
}

/// Extracts the code from a stored stage of the derivation.
template <std::same_as<image> Image>
constexpr extracted_code extract_code(const system_record& from, const Image& stored, std::string_view called,
                                      const survey& of_system, std::span<const request> all) {
  derived_system system(from, stored);
  visit(all, system.reader());
  extracted_code code = extract_code(system, called, of_system, all);
  code.follows_from_unparsed = system.reader().follows_from_unparsed();
  return code;
}

/// Returns the code for the results that the template arguments request.
template <class System, auto... wanted>
constexpr extracted_code code_for() {
  constexpr request all[]{requested<wanted>::value...};
  constexpr const survey& known = stages_of<System>::constrained.known;
  if constexpr (static_cast<bool>(stages_of<System>::constrained.mistake)) {
    return {};
  } else if constexpr (stage_for(all) == stage::constrained) {
    return extract_code(System::record, stages_of<System>::constrained.stored, type_name<System>(), known,
                        all);
  } else if constexpr (static_cast<bool>(stages_of<System>::equations.mistake)) {
    return extracted_code(stages_of<System>::equations.mistake);
  } else if constexpr (stage_for(all) == stage::equations) {
    return extract_code(System::record, stages_of<System>::equations.stored, type_name<System>(), known, all);
  } else if constexpr (static_cast<bool>(stages_of<System>::linearized.mistake)) {
    return extracted_code(stages_of<System>::linearized.mistake);
  } else {
    return extract_code(System::record, stages_of<System>::linearized.stored, type_name<System>(), known,
                        all);
  }
}

} // namespace kanexpr::derivation
