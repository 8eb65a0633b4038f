// The forms in which the equations of systems can be written, and what u' costs in each: explain [SYSTEM...].
#include <models/andrews.hpp>
#include <models/arm3.hpp>
#include <models/bicycle.hpp>
#include <models/double_pendulum.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/pendulum6.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>

#include <kanexpr/runtime/explain.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <span>
#include <string_view>

namespace {

struct known_system {
  std::string_view called;
  kanexpr::explanation (*explain)(const kanexpr::explain_options&);
};

constexpr known_system known_systems[] = {
    {"double_pendulum", kanexpr::explain<double_pendulum::System>},
    {"four_bar", kanexpr::explain<four_bar::System>},
    {"andrews", kanexpr::explain<andrews::System>},
    {"bicycle", kanexpr::explain<bicycle::System>},
    {"arm3", kanexpr::explain<arm3::System>},
    {"pendulum6", kanexpr::explain<pendulum6::System>},
    {"puma", kanexpr::explain<puma::System>},
    {"iiwa", kanexpr::explain<iiwa::System>},
    {"quadruped", kanexpr::explain<quadruped::System>},
};

int refuse(std::string_view name) {
  std::cerr << "explain: there is no system " << name << "; the systems are";
  for (const known_system& each : known_systems)
    std::cerr << (&each == known_systems ? " " : ", ") << each.called;
  std::cerr << '\n';
  return 1;
}

} // namespace

int main(int count, char** words) {
  const std::span<char* const> wanted(words + 1, static_cast<std::size_t>(count - 1));
  for (const std::string_view name : wanted)
    if (std::ranges::find(known_systems, name, &known_system::called) == std::end(known_systems))
      return refuse(name);
  for (const known_system& each : known_systems)
    if (wanted.empty() || std::ranges::find(wanted, each.called) != wanted.end())
      std::cout << each.called << '\n' << each.explain({}).text() << '\n';
}
