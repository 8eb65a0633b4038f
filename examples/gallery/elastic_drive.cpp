// A motor turns a disk through an elastic shaft, and a controller keeps the speed of the disk.
#include <kanexpr/simulate.hpp>
#include <models/elastic_drive.hpp>
#include <parts/page.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace elastic_drive {

struct Back : offset<Back, Ground, -0.07 * Ground::x> {};
struct Front : offset<Front, Ground, 0.05 * Ground::x> {};
struct Foot : offset<Foot, Ground, -0.02 * Ground::x - 0.055 * Ground::z> {};
struct Post : offset<Post, Disk, 0.06 * Ground::x> {};
struct Post_foot : offset<Post_foot, Post, -0.12 * Ground::z> {};
struct Rotor_mark : offset<Rotor_mark, Rotor, 0.062 * Ground::x + 0.035 * Rotor::z> {};
struct Rotor_hub : offset<Rotor_hub, Rotor, 0.062 * Ground::x> {};
struct Disk_mark : offset<Disk_mark, Disk, 0.014 * Ground::x + 0.075 * Disk::z> {};
struct Disk_hub : offset<Disk_hub, Disk, 0.014 * Ground::x> {};
struct Body : offset<Body, Ground, -0.01 * Ground::x> {};

constexpr auto twist = q_of<Rotor> - q_of<Disk>;

using picture = kanexpr::picture<
    System, up<Ground::z>, ground<-0.12>, seen_from<Ground::x - 1.4 * Ground::y + 0.6 * Ground::z>,
    show<cylinder<Ground, Body, Ground::x, 0.05, 0.12>, named<"motor">, colour<"#565e66">>,
    show<box<Ground, Foot, 0.1, 0.09, 0.13>, named<"foot">, colour<"#8f979e">>,
    show<cylinder<Rotor, Rotor_hub, Rotor::x, 0.045, 0.012>, named<"rotor">, colour<"#d98a2b">>,
    show<rod<Rotor_hub, Rotor_mark, 0.007>, named<"hand of the rotor">, colour<"#b5382f">>,
    show<rod<Rotor_hub, Post, 0.008>, named<"shaft">, colour<"#9aa3ab">>,
    show<cylinder<Disk, Disk, Disk::x, 0.09, 0.025>, named<"disk">, colour<"#3d6b99">>,
    show<rod<Disk_hub, Disk_mark, 0.007>, named<"hand of the disk">, colour<"#b5382f">>,
    show<rod<Post_foot, Post, 0.012>, named<"bearing">, colour<"#8f979e">>, plot<"twist of the shaft", twist>,
    plot<"voltage", Controller::output>, plot_energies<>>;

} // namespace elastic_drive

int main(int count, char** words) {
  using namespace elastic_drive;
  gallery::page page(
      count, words,
      {.title = "Motor with an elastic shaft",
       .kind = "Control",
       .see =
           "The reference of the speed rises, and later changes its sign; between them, a brake acts on the "
           "disk. The rotor leads and the shaft twists, so the disk swings about its speed until the "
           "back EMF of the motor has damped the vibration. The integral part of the controller and the "
           "current of the motor are states of the system.",
       .source = "Franklin, Powell & Emami-Naeini, Feedback Control of Dynamic Systems (2019), section 2.3; "
                 "Åström & Hägglund, Advanced PID Control (2006), section 3.5"});
  simulation_options<System> how{
      .relative_tolerance = 1e-10, .absolute_tolerance = 1e-12, .output_every = 0.005};
  how.inputs = [](double t, const state<System>&, input_values<System>& r) {
    const auto step = [t](double at) { return (1 + std::tanh((t - at) / 0.01)) / 2; };
    r[reference] = 6 * step(0.2) - 12 * step(3);
    r[T] = 0.15 * (step(1.4) - step(2.6));
  };
  const auto run = simulate<System>({{q_of<Rotor>, 0},
                                     {q_of<Disk>, 0},
                                     {u_of<Rotor>, 0},
                                     {u_of<Disk>, 0},
                                     {current_of<Rotor>, 0},
                                     {"s_Controller", 0}},
                                    {{J1, 4e-4},
                                     {J2, 1.6e-3},
                                     {k, 0.5},
                                     {c, 2e-3},
                                     {R, 1.2},
                                     {L, 1.2e-3},
                                     {kt, 0.08},
                                     {kp, 0.25},
                                     {ki, 1.2},
                                     {V, 12},
                                     {Tt, 0.2}},
                                    {0, 5}, how);
  double most_twist = 0, current_under_load = 0;
  for (const auto& s : run.trajectory) {
    most_twist = std::max(most_twist, std::abs(s.x[q_of<Rotor>] - s.x[q_of<Disk>]));
    if (s.t < 2.5) current_under_load = s.x[current_of<Rotor>];
  }
  std::printf("%g rad of twist, ends with %g rad/s\n", most_twist, run.state[u_of<Disk>]);
  page.expect(most_twist > 0.2, "the shaft twists visibly");
  page.expect_small("the current that the brake requires is T/kₜ",
                    std::abs(current_under_load * 0.08 / 0.15 - 1), 0.02);
  page.expect_small("the disk reaches the reference", std::abs(run.state[u_of<Disk>] + 6) / 6, 2e-3);
  return page.show<elastic_drive::picture>(run, {.at = 0.5});
}
