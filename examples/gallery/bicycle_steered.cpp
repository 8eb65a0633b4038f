// A bicycle slows down to a speed at which it would fall, and its handlebars keep it upright.
#include <kanexpr/fixed_step.hpp>
#include <kanexpr/simulations/trajectory/trajectory.hpp>
#include <loops/balanced_bicycle.hpp>
#include <parts/page.hpp>
#include <pictures/bicycle.hpp>

int main(int count, char** words) {
  using namespace balanced_bicycle;
  gallery::page page(
      count, words,
      {.title = "Bicycle kept upright by its handlebars",
       .kind = "Control",
       .see = "The bicycle is pushed to the side at 6 m/s and brakes to 2 m/s, where it would fall within "
              "seconds. The compiler has linearized it at nine speeds and computed the gains of a "
              "linear-quadratic regulator for each of them.",
       .source =
           "Meijaard, Papadopoulos, Ruina & Schwab, Proceedings of the Royal Society A 463 (2007), pages "
           "1955-1982; Franklin, Powell & Workman, Digital Control of Dynamic Systems (1998), section 9.2"});
  loop<double> riding(0.4);
  trajectory<Driven> path;
  for (int k = 1; k <= 1200; ++k) {
    if (const status s = riding.go_on(); !s) page.refuse(s.cause());
    if (k % 2 == 0) path.add({riding.t, riding.x, riding.r});
  }
  page.expect_constraints(path, 1e-6);
  double late = 0;
  for (const auto& s : path)
    if (s.t > 4) late = std::max(late, std::abs(s.x[q2]));
  page.expect(late < 0.1, "the bicycle leans by less than 0.1 rad after four seconds");
  page.expect(rear_radius * riding.x[u3] < 2.3, "the bicycle slows down to less than 2.3 m/s");
  return page.show<picture_of<Driven>>(
      path, {.eye = Eigen::Vector3d(-0.4, -1, 0.35), .angles = false, .lengths = false, .names = false});
}
