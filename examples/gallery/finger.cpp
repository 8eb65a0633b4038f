// A tendon bends a finger, and elastic tendons on its back open it again.
#include <kanexpr/joints.hpp>
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>

namespace finger {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"m", kilogram> m; // of the first phalanx; the others have 1/2 and 1/4 of it
constexpr parameter<"l", meter> l;    // its length; the others have 2/3 and 1/2 of it
constexpr parameter<"r", meter> r;    // from the axes of the bones to the tendons
constexpr parameter<"k", newton * meter / radian> k;          // of the joints
constexpr parameter<"c", newton * meter * second / radian> c; // of the joints
constexpr parameter<"s", newton / meter> s;                   // of the elastic tendons
constexpr parameter<"l1", meter> l1;                          // their natural lengths
constexpr parameter<"l2", meter> l2;
constexpr input<"F", newton> F; // the tension of the tendon that bends the finger

struct Hand : inertial_ground<Hand> {}; // x along the straight finger, z toward the back of the hand
struct First : pin<First, Hand, axis<Hand::y>, stops<-0.1, 1.7, 20.0, 0.05>,
                   body<m, 0.5 * l * own::x, inertia<own, m * r * r / 2, m * l * l / 12, m * l * l / 12>>> {};
struct Second
    : pin<Second, First, axis<First::y>, at<l * First::x>, stops<-0.05, 1.8, 20.0, 0.05>,
          body<m / 2, 0.33 * l * own::x, inertia<own, m * r * r / 5, m * l * l / 50, m * l * l / 50>>> {};
struct Third
    : pin<Third, Second, axis<Second::y>, at<0.67 * l * Second::x>,
          body<m / 4, 0.25 * l * own::x, inertia<own, m * r * r / 12, m * l * l / 150, m * l * l / 150>>> {};

// The tendon on the palm side passes through the eyes of its sheath.
struct Wrist : offset<Wrist, Hand, -0.9 * l * Hand::x - r * Hand::z> {};
struct Eye_1 : offset<Eye_1, Hand, -0.15 * l * Hand::x - 1.2 * r * Hand::z> {};
struct Eye_2 : offset<Eye_2, First, 0.25 * l * First::x - r * First::z> {};
struct Eye_3 : offset<Eye_3, First, 0.8 * l * First::x - r * First::z> {};
struct Eye_4 : offset<Eye_4, Second, 0.35 * l * Second::x - 0.9 * r * Second::z> {};
struct End : offset<End, Third, 0.15 * l * Third::x - 0.7 * r * Third::z> {};
using Tendon = through<Wrist, Eye_1, Eye_2, Eye_3, Eye_4, End>;

// Elastic tendons over the two larger joints, on the back.
struct Back : offset<Back, Hand, -0.25 * l * Hand::x + 1.05 * r * Hand::z> {};
struct Ridge : offset<Ridge, First, 0.2 * l * First::x + 0.95 * r * First::z> {};
struct Crest : offset<Crest, First, 0.8 * l * First::x + 0.9 * r * First::z> {};
struct Nail : offset<Nail, Second, 0.2 * l * Second::x + 0.85 * r * Second::z> {};
using Over_knuckle = around_cylinder<Hand, Hand, Hand::y, r, Back, Ridge, wrapping::counterclockwise>;
using Over_joint =
    around_cylinder<First, Second, First::y, 0.85 * r, Crest, Nail, wrapping::counterclockwise>;

struct System
    : kane_system<
          inertial<Hand>, joints<First, Second, Third>, parameters<m, l, r, k, c, s, l1, l2>, inputs<F>,
          loads<force_along<Tendon, F>, linear_spring<Over_knuckle, s, l1>, linear_spring<Over_joint, s, l2>,
                linear_spring<First, k>, linear_spring<Second, k>, linear_spring<Third, k>,
                joint_friction<First, c>, joint_friction<Second, c>, joint_friction<Third, c>>> {};

constexpr auto to_eye = position_of<Eye_4, Third>, to_end = position_of<End, Third>;
constexpr auto lever = magnitude(cross(to_eye, to_end)) / magnitude(to_end - to_eye);

struct Palm : offset<Palm, Hand, -0.5 * l * Hand::x> {};
struct Tip : offset<Tip, Third, 0.5 * l * Third::x> {};

template <class Point>
using eye = show<sphere<Point, 0.28 * r>, colour<"#20262b">>;

using picture = kanexpr::picture<
    System, up<Hand::z>, seen_from<0.25 * Hand::x - Hand::y + 0.3 * Hand::z>, trace<Tip, colour<"#9fb4c8">>,
    show<box<Hand, Palm, 0.8 * l, 1.4 * l, 1.3 * r>, named<"hand">, colour<"#c9ced3">>,
    show<cylinder<Hand, Hand, Hand::y, 0.97 * r, 2.2 * r>, named<"knuckle">, colour<"#8f979e">>,
    show<rod<Hand, Second, 0.5 * r>, named<"first phalanx">, colour<"#e8d8b8">>,
    show<cylinder<First, Second, First::y, 0.82 * r, 2.0 * r>, named<"middle joint">, colour<"#8f979e">>,
    show<rod<Second, Third, 0.45 * r>, named<"second phalanx">, colour<"#e8d8b8">>,
    show<cylinder<Second, Third, Second::y, 0.5 * r, 1.5 * r>, named<"last joint">, colour<"#8f979e">>,
    show<rod<Third, Tip, 0.4 * r>, named<"third phalanx">, colour<"#e8d8b8">>,
    show<sphere<Tip, 0.45 * r>, named<"tip">, colour<"#e8d8b8">>, eye<Eye_1>, eye<Eye_2>, eye<Eye_3>,
    eye<Eye_4>, eye<Back>, eye<Ridge>, eye<Crest>, eye<Nail>,
    show<cable<0.13 * r, Tendon>, named<"tendon">, colour<"#b5382f">>,
    show<cable<0.13 * r, Over_knuckle>, named<"elastic tendon over the knuckle">, colour<"#3d6b99">>,
    show<cable<0.13 * r, Over_joint>, named<"elastic tendon over the middle joint">, colour<"#3d6b99">>,
    plot_energies<>>;

} // namespace finger

int main(int count, char** words) {
  using namespace finger;
  gallery::page page(
      count, words,
      {.title = "Finger with tendons",
       .kind = "Mechanisms",
       .see =
           "A tendon through the eyes of its sheath bends all three joints. Two elastic tendons, which are "
           "wrapped around the knuckles, open the finger when the tension ends.",
       .source =
           "Brand & Hollister, Clinical Mechanics of the Hand (1999); Sherman, Seth & Delp, What is a moment "
           "arm?, ASME IDETC (2013)"});
  simulation_options<System> how{
      .relative_tolerance = 1e-9, .absolute_tolerance = 1e-11, .output_every = 0.01};
  const double pull = 11, hold = 1.9;
  how.inputs = [&](double t, const state<System>&, input_values<System>& given) {
    const auto step = [t](double at) { return (1 + std::tanh((t - at) / 0.12)) / 2; };
    given[F] = pull * (step(0.5) - step(2.2));
  };
  const double stiffness = 0.06;
  const auto run = simulate<System>(
      state<System>::Zero(),
      {{m, 0.03}, {l, 0.05}, {r, 0.008}, {k, stiffness}, {c, 2e-3}, {s, 250}, {l1, 0.019}, {l2, 0.017}},
      {0, 4}, how);
  const auto levers = run.trajectory.along<lever>();
  double unbalanced = 1, bent = 0;
  for (std::size_t i = 0; i < run.trajectory.size(); ++i) {
    const auto& at = run.trajectory[i];
    if (at.t > hold) continue;
    bent = at.x[q_of<First>] + at.x[q_of<Second>] + at.x[q_of<Third>];
    unbalanced = std::abs(stiffness * at.x[q_of<Third>] / (at.r[F] * levers[i]) - 1);
  }
  std::printf("bent by %g rad; at the end %g %g %g\n", bent, run.state[q_of<First>], run.state[q_of<Second>],
              run.state[q_of<Third>]);
  page.expect(bent > 2.5, "the finger bends by more than 2.5 rad");
  page.expect_small(
      "at rest, the tension times its lever about the last joint balances the torque of the joint",
      unbalanced, 0.02);
  page.expect(std::abs(run.state[q_of<First>]) < 0.15 && std::abs(run.state[q_of<Third>]) < 0.05,
              "the finger opens again");
  return page.show<finger::picture>(run, {.at = 1.2});
}
