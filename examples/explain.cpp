// The forms in which the equations of systems can be written, and what u' costs in each: explain [SYSTEM...].
#include <models/andrews.hpp>
#include <models/arm3.hpp>
#include <models/bicycle.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/pendulum6.hpp>
#include <models/puma.hpp>
#include <models/quadruped.hpp>

#include <kanexpr/runtime/explain.hpp>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string_view>

namespace {

template <class System>
void print(std::string_view called, std::span<char* const> wanted) {
  const auto is_wanted = [&](std::string_view each) { return each == called; };
  if (!wanted.empty() && std::ranges::none_of(wanted, is_wanted)) return;
  std::printf("%s\n%s\n", called.data(), kanexpr::explain<System>().text().c_str());
}

} // namespace

int main(int count, char** words) {
  const std::span<char* const> wanted(words + 1, static_cast<std::size_t>(count - 1));
  print<four_bar::System>("four_bar", wanted);
  print<andrews::System>("andrews", wanted);
  print<bicycle::System>("bicycle", wanted);
  print<arm3::System>("arm3", wanted);
  print<pendulum6::System>("pendulum6", wanted);
  print<puma::System>("puma", wanted);
  print<iiwa::System>("iiwa", wanted);
  print<quadruped::System>("quadruped", wanted);
}
