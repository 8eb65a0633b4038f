// Writes FMUs for with_fmpy.py into the folder that it is given, how they move, simulated here, and the same
// models for CasADi.
#include <kanexpr/export.hpp>
#include <kanexpr/fmi.hpp>
#include <kanexpr/simulate.hpp>
#include <models/bicycle.hpp>
#include <models/iiwa.hpp>
#include <models/simple_pendulum.hpp>
#include <simulations/falling_ball.hpp>

#include <fstream>
#include <iostream>

namespace {

using namespace kanexpr;

using values = std::vector<named_value>;

struct start_values {
  values x{}, p{}, r{};
};

template <class System>
bool write(const std::filesystem::path& folder, const std::string& name, double seconds,
           const start_values& start, std::vector<exporting::exported_event> events = {},
           std::vector<event<System>> here = {}) {
  values all = start.x;
  for (const values* each : {&start.p, &start.r}) all.insert(all.end(), each->begin(), each->end());
  const exporting::written_fmu written =
      write_fmu<System>(folder, name, {.start = all, .events = std::move(events), .step = 2e-4});
  const auto run = simulate<System>(start.x, start.p, {0, seconds},
                                    {.inputs = given_inputs<System>(start.r),
                                     .relative_tolerance = 1e-12,
                                     .absolute_tolerance = 1e-14,
                                     .output_every = seconds / 20,
                                     .events = std::move(here)});
  std::cerr << written.cause() << written.note() << run.cause();
  std::ofstream table(folder / (name + ".txt"));
  table.precision(17);
  for (const auto& s : run.trajectory) {
    table << s.t;
    for (const double entry : s.x) table << ' ' << entry;
    table << '\n';
  }
  const outcome for_casadi = write_casadi<System>(folder, name);
  std::cerr << for_casadi.cause();
  return written && written.note().empty() && run && for_casadi;
}

bool write_ball(const std::filesystem::path& folder) {
  using namespace falling_ball;
  return write<System>(folder, "ball", 2, {{{h, 1.2}, {v, 0}}, {{m, 0.3}, {g, 9.81}}},
                       {exporting::when<h>("bounce", crossing::falling, {exporting::set<-0.8 * v>(v)})},
                       {when<System, h>("bounce", crossing::falling,
                                        [](moment<System>& now) { now.x[v] = -0.8 * now.x[v]; })});
}

/// A push from the side at 5 m/s; the pitch and three speeds follow from the constraints.
bool write_bicycle(const std::filesystem::path& folder) {
  using namespace bicycle;
  return write<BoundSystem>(folder, "bicycle", 2,
                            {{{q1, 0}, {q2, 0.02}, {q5, 0.01}, {u2, 0.3}, {u3, 5 / 0.3}, {u5, 0}}});
}

/// It swings in its weight, with torques that hold some of it.
bool write_iiwa(const std::filesystem::path& folder) {
  start_values start;
  for (int i = 1; i <= 7; ++i) {
    const std::string place = std::to_string(i);
    start.x.push_back({"q" + place, 0.1 * i});
    start.x.push_back({"u" + place, 0.05 * i});
    start.r.push_back({"T" + place, 2.0 / i});
  }
  return write<iiwa::System>(folder, "iiwa", 1, start);
}

} // namespace

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  return write<simple_pendulum::System>(
             folder, "pendulum", 2,
             {{{"q", 0.3}, {"u", 0}}, {{"m", 2}, {"l", 0.5}, {"g", 9.81}, {"c", 0.1}}, {{"T", 0.2}}}) &&
                 write_ball(folder) && write_bicycle(folder) && write_iiwa(folder)
             ? 0
             : 1;
}
