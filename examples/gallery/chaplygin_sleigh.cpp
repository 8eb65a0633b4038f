// A sleigh that was pushed and turned glides on ice.
#include <kanexpr/simulate.hpp>
#include <models/chaplygin_sleigh.hpp>
#include <parts/page.hpp>

namespace chaplygin_sleigh {

struct Left : offset<Left, P, 1.6 * a * A::x + 0.9 * a * A::y> {};
struct Right : offset<Right, P, 1.6 * a * A::x - 0.9 * a * A::y> {};
struct Bow : offset<Bow, P, 0.35 * a * A::x> {};
struct Stern : offset<Stern, P, -0.35 * a * A::x> {};

using picture = kanexpr::picture<
    System, up<N::z>, ground<-0.02>, seen_from<N::x - 1.2 * N::y + 1.8 * N::z>, trace<P, colour<"#2f5d8a">>,
    trace<G, colour<"#d98a2b">>, show<rod<Stern, Bow, 0.05 * a>, colour<"#1d2430">, named<"blade">>,
    show<rod<P, Left, 0.05 * a>, colour<"#3d6b99">>, show<rod<P, Right, 0.05 * a>, colour<"#3d6b99">>,
    show<rod<Left, Right, 0.05 * a>, colour<"#3d6b99">>, show<sphere<G, 0.16 * a>, colour<"#b5382f">>>;

} // namespace chaplygin_sleigh

int main(int count, char** words) {
  using namespace chaplygin_sleigh;
  gallery::page page(
      count, words,
      {.title = "Chaplygin's sleigh",
       .kind = "Vehicles",
       .see = "The sleigh starts backward and turning; it swings around and ends in a straight line with its "
              "mass "
              "center ahead of the blade. No energy is lost, and yet the motion tends to one end: the "
              "constraint is nonholonomic.",
       .source = "Neimark & Fufaev, Dynamics of Nonholonomic Systems (1972), chapter 2"});
  const auto run = simulate<System>(
      {{q1, 0}, {q2, 0}, {q3, 0}, {u1, -1.2}, {u3, 0.4}}, {{m, 20}, {I, 4}, {a, 0.5}}, {0, 6},
      {.inputs = {{F, 0}, {T, 0}}, .relative_tolerance = 1e-10, .output_every = 0.02});
  page.expect_energy(run.trajectory, 1e-7);
  page.expect_constraints(run.trajectory, 1e-9);
  page.expect(run.state[u1] > 1.2 && std::abs(run.state[u3]) < 0.01,
              "the sleigh ends straight, its mass center ahead");
  return page.show<chaplygin_sleigh::picture>(run, {.at = 1});
}
