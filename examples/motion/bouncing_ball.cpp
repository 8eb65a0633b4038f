// A ball that is thrown bounces until it hardly leaves the ground: an event changes the state and finally
// stops the simulation.
#include "output.hpp"

#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/progress.hpp>

#include <cstdio>

namespace {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"h", meter> h; // height of its lowest point
constexpr speed<"vx"> vx;
constexpr speed<"vh"> vh;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"R", meter> R;
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // z points up
struct O : origin<O, N> {};
struct Centre : offset<Centre, O, x * N::x + (h + R) * N::z> {};
struct Ball : particle<Ball, Centre, m> {};

struct System
    : kane_system<inertial<N>, coordinates<x, h>, speeds<vx, vh>, kinematics<dot(x) == vx, dot(h) == vh>,
                  parameters<m, R, g>, bodies<Ball>, loads<gravity<-g * N::z>>> {};

using picture_of_ball = kanexpr::picture<System, up<N::z>, ground<>, trace<Centre>, show<sphere<Centre, R>>>;

constexpr double restitution = 0.8, least_speed = 0.3;

after_event bounce(moment<System>& now) {
  now.x[vh] *= -restitution;
  return now.x[vh] < least_speed ? after_event::stop : after_event::go_on;
}

} // namespace

int main(int count, char** words) {
  const output files("A bouncing ball", "A ball that loses a fifth of its speed at each bounce.", count,
                     words);
  const auto run =
      simulate<System>({{x, 0}, {h, 1.2}, {vx, 0.7}, {vh, 0}}, {{m, 0.3}, {R, 0.1}, {g, 9.81}}, {0, 20},
                       {.relative_tolerance = 1e-11,
                        .absolute_tolerance = 1e-13,
                        .output_every = 0.01,
                        .events = {when<System, h>("bounce", crossing::falling, bounce)},
                        .progress = progress_bar()});
  if (!run) return std::fprintf(stderr, "%s\n", run.cause().c_str()), 1;

  for (const auto& bounce : run.events) std::printf("bounces at %.6f s\n", bounce.t);
  return files.leave<picture_of_ball>(run.trajectory) ? 0 : 1;
}
