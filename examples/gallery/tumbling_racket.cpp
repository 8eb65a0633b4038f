// A body that spins about its intermediate axis turns over again and again.
#include <kanexpr/joints.hpp>
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace tumbling_racket {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"e1"> e1; // the orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"w1"> w1; // the angular velocity, in the axes of the body
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"A", kilogram * pow<2>(meter)> A;
constexpr parameter<"B", kilogram * pow<2>(meter)> B;
constexpr parameter<"C", kilogram * pow<2>(meter)> C;

struct N : inertial_frame<N> {};
struct F : quaternion<F, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct O : origin<O, N> {};
struct Nut : rigid_body<Nut, O, F, m, inertia<F, A, B, C>> {};
struct System : kane_system<inertial<N>, coordinates<e1, e2, e3, e0>, speeds<w1, w2, w3>,
                            kinematics<kinematics_of<F, N>>, parameters<A, B, C, m>, bodies<Nut>> {};

struct Top : offset<Top, O, 0.09 * F::x> {};
struct Bottom : offset<Bottom, O, -0.09 * F::x> {};
struct Stem : offset<Stem, O, 0.13 * F::y> {};

using picture =
    kanexpr::picture<System, up<N::y>, seen_from<N::z + 0.5 * N::x + 0.35 * N::y>,
                     trace<Stem, colour<"#d98a2b">>, show<rod<Bottom, Top, 0.014>, colour<"#8f979e">>,
                     show<rod<O, Stem, 0.02>, colour<"#3d6b99">>, show<sphere<Top, 0.024>, colour<"#b5382f">>,
                     show<sphere<Bottom, 0.024>, colour<"#5d8a4a">>>;

} // namespace tumbling_racket

int main(int count, char** words) {
  using namespace tumbling_racket;
  gallery::page page(
      count, words,
      {.title = "Tumbling wing nut",
       .kind = "Gyroscopes",
       .see = "The nut spins steadily about its stem for a while, suddenly turns over, and spins on with the "
              "stem pointing the other way. Rotation about the axis of the intermediate moment of inertia "
              "is unstable; Dzhanibekov saw it in orbit in 1985.",
       .source = "Ashbaugh, Chicone & Cushman, The twisting tennis racket, Journal of Dynamics and "
                 "Differential Equations 3 (1991), pages 67-85"});
  const auto run = simulate<System>({{e1, 0}, {e2, 0}, {e3, 0}, {e0, 1}, {w1, 0.004}, {w2, 6}, {w3, 0}},
                                    {{A, 1e-4}, {B, 2e-4}, {C, 2.6e-4}, {m, 0.1}}, {0, 16},
                                    {.relative_tolerance = 1e-11, .output_every = 0.01});
  using eom = equations_of_motion<System>;
  page.expect_energy(run.trajectory, 1e-8);
  std::vector<double> momentum;
  double least = 1;
  for (const auto& sample : run.trajectory) {
    const Eigen::Vector3d h = eom::angular_momentum(sample.x, run.trajectory.parameters());
    momentum.push_back(h.norm());
    least = std::min(least, 1 - 2 * (sample.x[e1] * sample.x[e1] + sample.x[e3] * sample.x[e3]));
  }
  page.expect_constant("the angular momentum", momentum, momentum.front(), 1e-8);
  page.expect(least < -0.9, "the stem turns over");
  return page.show<tumbling_racket::picture>(run, {.at = 1});
}
