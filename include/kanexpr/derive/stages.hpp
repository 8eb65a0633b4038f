#pragma once

#include <kanexpr/derive/check_words.hpp>
#include <kanexpr/derive/take_survey.hpp>

/// The derivation of a system in stages, each of which goes on where the one before it was set aside. A stage
/// is derived when something of it is asked for, and once.
namespace kanexpr::deriving {

using mechanics::stage;

/// Forms what belongs to a stage, of equations that have come through the one before it.
constexpr void go_on(mechanics::equations& e, stage to) {
  switch (to) {
  case stage::constrained: e.constrain(); break;
  case stage::equations: e.get(mechanics::quantity::udot); break;
  case stage::linearized: e.linearized().reduced().explicit_form(); break;
  }
}

/// The same of a system, whose first stage begins with what was read.
constexpr void go_on(derived_system& system, stage to) {
  if (to != stage::constrained) return go_on(system.equations(), to);
  system.check_model();
  system.derive();
}

/// Where a stage ended: at a mistake, or set aside. It has room for any model, so a program must not hold it.
struct staged {
  sentence mistake{};
  bool follows_from_unparsed = false; ///< the compiler has told an error about it already
  image aside{};

  template <std::same_as<derived_system> System>
  constexpr void take(const System& system, std::string_view called) {
    mistake = system.mistake();
    if (mistake) return;
    system.write(aside);
    if (aside.is_full) mistake = sentence({called, " is larger than any system that there is room for"});
  }
};

/// The first stage, and what is known of a system from then on. With a mistake, what was known before it was
/// met.
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
    go_on(system, stage::constrained);
    s.known.take(system);
    s.follows_from_unparsed = system.reader().follows_from_unparsed();
    s.take(system, type_name<System>());
    if (s.known.symbols() > survey::room) {
      if (!s.mistake)
        s.mistake = sentence(
            {type_name<System>(), " has more than ", mechanics::counted(survey::room).view(), " symbols"});
      s.known = {}; // which has no names of them
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
    derived_system system(System::record, before.aside);
    go_on(system, to);
    s.take(system, type_name<System>());
  }
  return s;
}

/// The stages of a system. Each constant is evaluated where it is first used.
template <class System>
struct stages_of {
  static constexpr surveyed_stage constrained = first_stage<System>();
  static constexpr staged equations = next_stage<System>(constrained, stage::equations);
  static constexpr staged linearized = next_stage<System>(equations, stage::linearized);
};

} // namespace kanexpr::deriving
