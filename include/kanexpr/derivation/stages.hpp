#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/check_words.hpp>
#include <kanexpr/derivation/derived_system.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/quantity.hpp>

#include <string_view>

/// Derives a system in stages, each of which resumes from the stored result of the previous one. A stage is
/// derived when one of its results is first requested.
namespace kanexpr::derivation {

using mechanics::stage;

/// Advances the equations to stage `to`; they must have completed the previous one.
constexpr void advance(mechanics::equations& e, stage to) {
  switch (to) {
  case stage::constrained: e.constrain(); break;
  case stage::equations: e.get(mechanics::quantity::udot); break;
  case stage::linearized: e.linearized().reduced().explicit_form(); break;
  }
}

/// Advances a system to stage `to`; its first stage starts from the model that was read.
constexpr void advance(derived_system& system, stage to) {
  if (to != stage::constrained) return advance(system.equations(), to);
  system.check_model();
  system.derive();
}

/// The result of a stage: a mistake, or the stored derivation. The arrays are large enough for any model, so
/// programs must not store such an object.
struct staged {
  sentence mistake{};
  /// Whether the compiler has already reported an error about the type that contains the mistake.
  bool follows_from_unparsed = false;
  image stored{};

  template <std::same_as<derived_system> System>
  constexpr void take(System& system, std::string_view called) {
    mistake = system.mistake();
    if (mistake) return;
    system.write(stored);
    if (stored.is_full) mistake = sentence({called, " exceeds the supported size of a system"});
  }
};

/// The first stage and the survey of a system. If there is a mistake, the survey contains the properties that
/// were known before it occurred.
struct surveyed_stage : staged {
  survey known{};
};

template <class System>
constexpr surveyed_stage first_stage() {
  surveyed_stage s;
  s.known.mistake = s.mistake = words_of<System>.mistake;
  s.follows_from_unparsed = describe::is_unparsed<System>();
  if constexpr (requires { System::record; }) {
    if (s.mistake) return s;
    derived_system system(System::record);
    advance(system, stage::constrained);
    s.known.take(system);
    s.follows_from_unparsed = system.reader().follows_from_unparsed();
    s.take(system, type_name<System>());
    if (s.known.symbols() > survey::room) {
      if (!s.mistake)
        s.mistake = sentence(
            {type_name<System>(), " has more than ", base::counted(survey::room).view(), " symbols"});
      s.known = {}; // the names do not fit
    }
  }
  s.known.mistake = s.mistake;
  return s;
}

template <class System>
constexpr staged next_stage(const staged& before, stage to) {
  staged s;
  if constexpr (requires { System::record; }) {
    if (before.mistake) return s;
    derived_system system(System::record, before.stored);
    advance(system, to);
    s.take(system, type_name<System>());
  }
  return s;
}

/// The stages of a system. Each constant is evaluated on first use.
template <class System>
struct stages_of {
  static constexpr surveyed_stage constrained = first_stage<System>();
  static constexpr staged equations = next_stage<System>(constrained, stage::equations);
  static constexpr staged linearized = next_stage<System>(equations, stage::linearized);
};

} // namespace kanexpr::derivation
