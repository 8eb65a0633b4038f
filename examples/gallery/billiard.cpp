// A billiard ball that is struck from above slides, curves around another ball, and rolls straight on.
#include <kanexpr/simulate.hpp>
#include <models/billiard_ball.hpp>
#include <parts/page.hpp>

#include <Eigen/Geometry>

#include <cmath>

namespace billiard {

using namespace billiard_ball;

struct Mark : offset<Mark, Ball, 0.55 * r * Ball::z> {};
struct Side : offset<Side, Ball, 0.55 * r * Ball::y> {};
struct Other : offset<Other, Table, 0.62 * Table::x + 0.02 * Table::y + r * Table::z> {};
struct Pocket : offset<Pocket, Table, 1.154 * Table::x + 0.728 * Table::y> {};
struct Slate : offset<Slate, Table, 0.55 * Table::x + 0.27 * Table::y - 0.0105 * Table::z> {};

constexpr auto slip_speed = magnitude(slip);
constexpr auto along = dot(velocity_of<Ball>, Table::x), across = dot(velocity_of<Ball>, Table::y);

using picture = kanexpr::picture<
    System, up<Table::z>, seen_from<-Table::x - 2.2 * Table::y + 2.2 * Table::z>,
    trace<Ball, colour<"#f2e6c8">>, plot<"slip speed", slip_speed>, plot_energies<>, show_forces<"N">,
    show_velocities<"m/s">, show<box<Table, Slate, 1.4, 1.1, 0.02>, named<"table">, colour<"#2f7a57">>,
    show<ellipsoid<Table, Pocket, 0.055, 0.055, 0.006>, named<"pocket">, colour<"#20262b">>,
    show<sphere<Other, r>, colour<"#dfa63c">>, show<sphere<Ball, r>, colour<"#f5f3ec">>,
    show<sphere<Mark, 0.5 * r>, colour<"#b5382f">>, show<sphere<Side, 0.5 * r>, colour<"#b5382f">>>;

} // namespace billiard

int main(int count, char** words) {
  using namespace billiard;
  gallery::page page(
      count, words,
      {.title = "Billiard shot",
       .kind = "Rolling",
       .see =
           "The cue strikes the ball from above, so it spins backward and to the side. While it slides, the "
           "direction of the friction does not change, and its path is a parabola around the other ball. "
           "When the sliding ends, the ball rolls straight into the pocket.",
       .source = "Coriolis, Théorie mathématique des effets du jeu de billard (1835)"});
  const double mass = 0.17, radius = 0.028575, gravity_strength = 9.81, friction_coefficient = 0.2,
               stiffness = 1e7;
  const double sunk = std::pow(mass * gravity_strength / stiffness, 2.0 / 3);
  const Eigen::Vector3d v(1.5, 0, 0), w(-70, -60, 0);
  state<System> x{};
  x[q_of<Ball, 3>] = radius - sunk, x[q_of<Ball, 7>] = 1;
  x[u_of<Ball, 1>] = v(0), x[u_of<Ball, 4>] = w(0), x[u_of<Ball, 5>] = w(1);
  const auto run = simulate<System>(
      x,
      {{m, mass},
       {r, radius},
       {g, gravity_strength},
       {mu, friction_coefficient},
       {s, 1e-3},
       {k, stiffness},
       {d, sunk / 4}},
      {0, 1.55}, {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12, .output_every = 0.005});
  const Eigen::Vector3d slipping = v - radius * w.cross(Eigen::Vector3d::UnitZ());
  const double end = 2 * slipping.norm() / (7 * friction_coefficient * gravity_strength);
  const Eigen::Vector3d rolling = v - 2 * slipping / 7;
  std::printf("slides %g s, %g m/s; ends at %g %g\n", end, rolling.norm(), run.state[q_of<Ball, 1>],
              run.state[q_of<Ball, 2>]);
  const auto speeds = run.trajectory.along<slip_speed>();
  double longest = 0;
  for (std::size_t i = 0; i < speeds.size(); ++i)
    if (speeds[i] > 0.01) longest = run.trajectory[i].t;
  page.expect_small("the ball slides for 2 s/(7 μ g), where s is the slip speed at first",
                    std::abs(longest / end - 1), 0.02);
  const Eigen::Vector2d last(run.trajectory.along<along>().back(), run.trajectory.along<across>().back());
  page.expect_small("the ball then rolls with the velocity v − 2 s/7",
                    (last - rolling.head<2>()).norm() / v.norm(), 1e-3);
  return page.show<billiard::picture>(run, {.at = 0.3});
}
