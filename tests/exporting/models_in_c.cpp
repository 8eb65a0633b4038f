// Exports models to the folder given as argument, for the tests that compile the files.
#include "bead.hpp"
#include "curved.hpp"
#include "sliders.hpp"

#include <kanexpr/export.hpp>
#include <kanexpr/fmi.hpp>
#include <kanexpr/units/si.hpp>

#include <models/appell_hamel.hpp>
#include <models/bouncing_ball.hpp>
#include <models/cornering_car.hpp>
#include <models/four_bar.hpp>
#include <models/iiwa.hpp>
#include <models/motor_arm.hpp>
#include <models/n_pendulum_cart.hpp>
#include <models/rolling_disc.hpp>
#include <models/simple_pendulum.hpp>
#include <runtime/driven_wheel.hpp>
#include <runtime/loaded_arm.hpp>
#include <runtime/slewing_arm.hpp>
#include <simulations/falling_ball.hpp>
#include <steps/quaternions.hpp>

#include <docs/guide/muscles/elbow.cpp>

#include <iostream>

namespace {

using namespace kanexpr::exporting;

template <class System>
bool write(const char* folder, const char* name, c_options chosen) {
  chosen.number = precision::double_precision;
  kanexpr::outcome written = kanexpr::write_c<System>(folder, name, chosen);
  if (written) {
    chosen.number = precision::single_precision;
    written = kanexpr::write_c<System>(folder, name + std::string("_in_float"), chosen);
  }
  if (!written) std::cerr << written.cause() << '\n';
  return static_cast<bool>(written);
}

/// A pendulum driven by a force that depends on time; no parameter is bound.
bool write_driven(const char* folder) {
  kanexpr::runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u"), g = b.parameter("g"),
             amplitude = b.parameter("amplitude");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  const auto P = b.offset("P", b.origin("O"), b.along(A, 2, 0, 0));
  b.particle("Bob", P, b.number(3));
  b.gravity(b.along(N, g, 0, 0));
  b.force(P, b.along(N, 0, amplitude * sin(2 * b.time()), 0));
  return static_cast<bool>(kanexpr::write_casadi(b, folder, "driven"));
}

/// A system without inputs and parameters, with names that C or the generated code uses otherwise.
bool write_awkward(const char* folder) {
  kanexpr::runtime::builder b("N");
  const auto q = b.coordinate("by_x"), s = b.coordinate("int"), u = b.speed("residual"), v = b.speed("w 1");
  b.kinematic_equation(b.dot(q) - u);
  b.kinematic_equation(b.dot(s) - v);
  const auto N = b.inertial_frame();
  const auto A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  const auto P = b.offset("P", b.origin("O"), b.along(A, s, 0, 0));
  b.particle("Bob", P, b.number(3));
  b.gravity(b.along(N, 9.81, 0, 0));
  return static_cast<bool>(kanexpr::write_casadi(b, folder, "a"));
}

/// A driven wheel with a tyre after the Magic Formula.
bool write_wheel(const char* folder) {
  kanexpr::runtime::builder b("N");
  const auto x = b.coordinate("x"), angle = b.coordinate("angle"), v = b.speed("v"), spin = b.speed("spin"),
             radius = b.parameter("R"), load = b.parameter("F"), torque = b.input("T");
  b.kinematic_equation(b.dot(x) - v);
  b.kinematic_equation(b.dot(angle) - spin);
  const auto N = b.inertial_frame(), rim = b.rotated("Rim", N, angle, b.along(N, 0, 1, 0));
  const auto O = b.origin("O"), hub = b.offset("Hub", O, b.along(N, x, 0, radius));
  b.rigid_body("Wheel", hub, rim, b.number(2), b.inertia(rim, 0.1, 0.15, 0.1));
  b.torque(rim, b.along(N, 0, torque, 0));
  auto tyre = kanexpr::runtime::tyre_data::of_formula(
      {.Fz0 = 1, .R0 = 1, .pCx1 = 1.6, .pDx1 = 1.1, .pEx1 = 0.3, .pKx1 = 20, .pKx3 = 0.2, .qsy1 = 0.01});
  tyre.load = load, tyre.standstill = 0.5;
  b.tyre(b.wheel_on_plane({hub, rim, b.along(N, 0, 1, 0), radius}, O, b.along(N, 0, 0, 1)), tyre);
  return static_cast<bool>(kanexpr::write_casadi(b, folder, "wheel"));
}

bool write_for_casadi(const char* folder, const casadi_options& bound) {
  using namespace kanexpr;
  using System = n_pendulum_cart::System<1>;
#include <docs/export/casadi/write.cpp>
  return written && write_driven(folder) && write_awkward(folder) && write_wheel(folder) &&
         write_casadi<simple_pendulum::System>(folder, "bound_pendulum", bound) &&
         write_casadi<rolling_disc::System>(folder, "disc", {.step = "semi_implicit_euler"}) &&
         write_casadi<motor_arm::System>(folder, "motor_arm", {.step = "runge_kutta_4"}) &&
         write_casadi<loaded_arm::System>(folder, "loaded_arm", {.step = "runge_kutta_4"}) &&
         write_casadi<cornering_car::System>(folder, "cornering_car",
                                             {.bound = {{"s", 4}}, .step = "runge_kutta_4"}) &&
         write_casadi<elbow::System>(folder, "elbow");
}

bool is_whole(const kanexpr::exporting::written_fmu& written) {
  std::cerr << written.cause() << written.note();
  return written && written.note().empty();
}

/// A pendulum with names that C and XML do not allow, and with a load that depends on time.
bool write_strange_fmu(const char* folder) {
  kanexpr::runtime::builder b("N");
  const auto q = b.coordinate("time"), u = b.speed("ω <&>"), g = b.parameter("der(time)"),
             amplitude = b.parameter("a+b");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  const auto P = b.offset("P", b.origin("O"), b.along(A, 2, 0, 0));
  b.particle("Bob", P, b.number(3));
  b.gravity(b.along(N, g, 0, 0));
  b.force(P, b.along(N, 0, amplitude * sin(2 * b.time()), 0));
  using kanexpr::crossing;
  const std::vector<exported_event> events{
      when("flip", q, crossing::either, {set("time", -q)}), // does not end the motion
      when("half a second", b.time() - 0.5, crossing::rising, {}, kanexpr::after_event::stop)};
  return is_whole(
      kanexpr::write_fmu(b, folder, "strange",
                         {.outputs = {expression("\"a\tb\xff", q * u), expression("der(ω <&>)", q * q)},
                          .start = {{"time", 0.3}, {"der(time)", 9.81}, {"a+b", 2}},
                          .events = events}));
}

bool write_pendulum_fmu(const char* folder) {
  using namespace kanexpr;
  using namespace simple_pendulum;
#include <docs/export/fmi/write.cpp>
  return is_whole(written);
}

bool write_ball_fmu(const char* folder) {
  using namespace kanexpr;
  using namespace falling_ball;
#include <docs/export/fmi/events.cpp>
  return is_whole(ball);
}

/// A weightless lift, with units, that jumps up when it arrives, past the position of another event, with
/// long internal steps.
bool write_lift_fmu(const char* folder) {
  kanexpr::runtime::builder b("N");
  const auto h = b.coordinate("h", kanexpr::units::si::meter), v = b.speed("v");
  b.kinematic_equation(b.dot(h) - v);
  const auto N = b.inertial_frame();
  b.particle("Lift", b.offset("P", b.origin("O"), b.along(N, h, 0, 0)), b.number(1));
  using kanexpr::crossing;
  return is_whole(
      kanexpr::write_fmu(b, folder, "lift",
                         {.start = {{"h", 1}, {"v", -1}},
                          .events = {when("arrival", h, crossing::falling, {set("h", b.number(5))}),
                                     when("four", h - 4, crossing::rising, {set("v", b.number(7))})},
                          .step = 1}));
}

/// An arm with a motor and a controller, whose states are state variables.
bool write_motor_arm_fmu(const char* folder) {
  using namespace motor_arm;
  fmu_options chosen{.outputs = {expression<voltage>("voltage")}};
  chosen.start = {{"m", 2},    {"l", 0.5}, {"g", 9.81}, {"n", 20},     {"k", 0.05}, {"R", 0.8},
                  {"L", 0.01}, {"kp", 30}, {"ki", 20},  {"tau", 0.25}, {"i", 0.3},  {"r", 1}};
  chosen.step = 1.0 / 1024;
  return is_whole(kanexpr::write_fmu<System>(folder, "motor_arm", chosen));
}

/// An arm, a car and a wheel on which loads of most kinds act.
bool write_loaded_fmus(const char* folder) {
  fmu_options arm, car, wheel;
  arm.step = car.step = wheel.step = 1.0 / 1024;
  arm.start = {{"k", 20}, {"c", 0.5}, {"mu", 0.4}, {"V", 3}};
  car.start = {{"u", 20},    {"w_f", 66},    {"w_r", 67}, {"T", 100}, {"delta", 0.05}, {"m", 1500},
               {"J", 2400},  {"g", 9.81},    {"a", 1.2},  {"b", 1.6}, {"R", 0.3},      {"mu", 0.9},
               {"C_f", 9e4}, {"C_r", 1.1e5}, {"s", 0.4},  {"v0", 0.1}};
  wheel.start = {{"k", 1e4}, {"mu", 0.9}, {"F", 300}, {"s", 0.2}, {"w", 2}, {"e", 0.3}, {"q_Frame", 0.3}};
  return is_whole(kanexpr::write_fmu<loaded_arm::System>(folder, "loaded_arm", arm)) &&
         is_whole(kanexpr::write_fmu<cornering_car::System>(folder, "cornering_car", car)) &&
         is_whole(kanexpr::write_fmu<driven_wheel::System>(folder, "driven_wheel", wheel));
}

bool write_fmus(const char* folder, const options& of_bound) {
  const fmu_options bound{.outputs = of_bound.functions,
                          .bound = of_bound.bound,
                          .start = {{"q", 0.3}, {"l", 0.5}, {"c", 0.1}},
                          .step = 0.01,
                          .method = "ralston_3"};
  fmu_options beaded, sliding, linked, on_cone;
  linked.start = {{"q1", 0.3}, {"q2", 0.5}, {"q3", -1.8}, {"u1", 1},   {"g", 9.81}, {"l0", 4},
                  {"l1", 1},   {"l2", 3},   {"l3", 2.5},  {"d1", 0.5}, {"d2", 1.5}, {"d3", 1.2},
                  {"m1", 1},   {"m2", 2},   {"m3", 1.5},  {"I1", 0.1}, {"I2", 0.5}, {"I3", 0.3}};
  beaded.start = {{"s", 0.4}, {"m", 2}, {"w", 1.5}, {"g", 9.81}, {"push", 0.7}};
  on_cone.start = {{"u", 0.6}, {"v", -0.8}, {"w", 1}, {"m", 1.3}, {"a", 0.5}, {"g", 9.81}}; // w is a guess
  sliding.method = "ralston_3";
  beaded.step = sliding.step = 0.125; // all sums of them are exact
  sliding.start = {{"e0", 0.6}, {"e1", 0.5}, {"e2", 0.3}, {"e3", 0.4}, {"u1", 0.3}, {"h", -0.2}};
  return is_whole(kanexpr::write_fmu<simple_pendulum::System>(folder, "bound_pendulum", bound)) &&
         write_pendulum_fmu(folder) && write_ball_fmu(folder) && write_strange_fmu(folder) &&
         write_lift_fmu(folder) &&
         is_whole(kanexpr::write_fmu<four_bar::System>(folder, "four_bar", linked)) &&
         is_whole(kanexpr::write_fmu<appell_hamel::System>(folder, "appell_hamel", on_cone)) &&
         is_whole(kanexpr::write_fmu<bead::System>(folder, "bead", beaded)) && write_motor_arm_fmu(folder) &&
         is_whole(kanexpr::write_fmu<quaternions::Sliding>(folder, "sliding", sliding)) &&
         write_loaded_fmus(folder);
}

} // namespace

int main(int, char** arguments) {
  const char* const folder = arguments[1];
  c_options dynamics, with_python;
  with_python.with_python = with_python.with_cpp = true;
  dynamics.with_python = true;
  dynamics.functions = {results("udot"), results("inverse_dynamics")};
  c_options bound{
      .functions = {results("udot"), results("mass_matrix forcing"),
                    expression<kanexpr::position_of<simple_pendulum::P, simple_pendulum::O>>("tip")},
      .bound = {{"g", 9.81}, {"m", 2}},
      .number = precision::single_precision};
  using namespace kanexpr;
  using namespace simple_pendulum;
#include <docs/export/c/write.cpp>
  const bool is_bound_written =
      written &&
      static_cast<bool>(kanexpr::write_c<simple_pendulum::System>(folder, "bound_pendulum", bound));
  c_options steps;
  steps.with_python = steps.with_cpp = true;
  steps.functions = {results("runge_kutta_4"), results("ralston_3"),
                     fixed_step("euler", {"semi_implicit_euler", 2})};
  c_options loaded; // rates, derivatives and steps of systems with loads
  loaded.with_python = true;
  loaded.functions = {results("udot"), results("explicit_form"), results("runge_kutta_4")};
  c_options linearized; // its u̇ always exists
  linearized.with_python = true;
  linearized.functions = {results("udot"), results("explicit_form"), results("implicit_form"),
                          results("jacobian")};
  c_options in_pieces;
  in_pieces.lengths = {.longest = 100, .piece = 40};
  c_options many_columns; // their systems are solved in loops
  many_columns.functions = {results("explicit_form")};
  c_options columns_in_pieces = many_columns;
  columns_in_pieces.lengths = {.longest = 1000, .piece = 150};
  return is_bound_written && write_for_casadi(folder, {bound.bound, "ralston_3"}) &&
                 write_fmus(folder, bound) && write<quaternions::Sliding>(folder, "sliding", steps) &&
                 write<bead::System>(folder, "bead", steps) &&
                 write<appell_hamel::System>(folder, "appell_hamel", steps) &&
                 write<motor_arm::System>(folder, "motor_arm", {}) &&
                 write<loaded_arm::System>(folder, "loaded_arm", loaded) &&
                 write<cornering_car::System>(folder, "cornering_car", loaded) &&
                 write<driven_wheel::System>(folder, "driven_wheel", loaded) &&
                 write<iiwa::System>(folder, "iiwa", dynamics) &&
                 write<iiwa::System>(folder, "iiwa_columns", many_columns) &&
                 write<iiwa::System>(folder, "iiwa_in_pieces", columns_in_pieces) &&
                 write<four_bar::System>(folder, "four_bar", with_python) &&
                 write<four_bar::System>(folder, "four_bar_in_pieces", in_pieces) &&
                 write<rolling_disc::System>(folder, "disc", {}) &&
                 write<curved::System>(folder, "curved", {}) &&
                 write<sliders::System>(folder, "sliders", linearized) &&
                 write<slewing_arm::System>(folder, "slewing_arm", {}) &&
                 write<bouncing_ball::System>(folder, "bouncing_ball", {})
             ? 0
             : 1;
}
