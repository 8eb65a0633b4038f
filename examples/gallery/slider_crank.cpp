// The flywheel of an engine coasts, and its piston goes up and down.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace slider_crank {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"q1", radian> q1; // of the crank
constexpr coordinate<"q2", radian> q2; // of the rod, relative to the crank
constexpr speed<"u1"> u1;
constexpr speed<"u2"> u2;
constexpr parameter<"r", meter> r;                    // crank
constexpr parameter<"l", meter> l;                    // rod
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // flywheel
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"M", kilogram> M; // piston
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_frame<N> {}; // x points up, along the cylinder
struct A : rotated<A, N, q1, N::z> {};
struct B : rotated<B, A, q2, A::z> {};
struct O : origin<O, N> {};
struct C : offset<C, O, r * A::x> {};
struct G : offset<G, C, l / 2 * B::x> {};
struct P : offset<P, C, l * B::x> {};
struct Flywheel : rigid_body<Flywheel, O, A, 1, inertia<A, 0, 0, J>> {};
struct Rod : rigid_body<Rod, G, B, m, inertia<B, 0, 0, I>> {};
struct Piston : particle<Piston, P, M> {};

struct System : kane_system<inertial<N>, coordinates<q1, q2>, speeds<u1, u2>, kinematics<simple>,
                            configuration_constraints<zero_along<position_of<P, O>, N::y>>, dependent<q2, u2>,
                            bodies<Flywheel, Rod, Piston>, loads<gravity<-g * N::x>>> {};

struct Rim : offset<Rim, O, -0.09 * N::z> {};
struct Low : offset<Low, O, 0.15 * N::x> {};
struct Head : offset<Head, P, 0.03 * N::x> {};

using picture = kanexpr::picture<
    System, up<N::x>, seen_from<N::z + 0.6 * N::y + 0.35 * N::x>,
    show<wheel<A, Rim, A::z, 0.13, 0.04>, colour<"#8f979e">>, show<rod<Rim, O, 0.014>, colour<"#8f979e">>,
    show<rod<O, C, 0.016>, colour<"#b5382f">, named<"crank">>,
    show<rod<C, P, 0.011>, colour<"#3d6b99">, named<"connecting rod">>,
    show<sphere<C, 0.018>, colour<"#8f979e">>,
    show<cylinder<N, Head, N::x, 0.042, 0.07>, colour<"#c4c8cb">, opacity<0.75>, named<"piston">>>;

} // namespace slider_crank

int main(int count, char** words) {
  using namespace slider_crank;
  gallery::page page(count, words,
                     {.title = "Slider-crank",
                      .kind = "Mechanisms",
                      .see = "The flywheel coasts and drives the piston; its speed drops whenever the piston "
                             "is fast. The piston does not move "
                             "as a sine: it is faster near the top, because the connecting rod is only three "
                             "times as long as the crank.",
                      .source = "Norton, Design of Machinery, 6th edition (2019), chapter 13"});
  const auto run =
      simulate<System>({{q1, 0.3}, {q2, -0.4}, {u1, 12}},
                       {{r, 0.05}, {l, 0.15}, {J, 0.004}, {m, 0.5}, {I, 1.2e-3}, {M, 0.6}, {g, 9.81}}, {0, 4},
                       {.guesses_dependent = true, .relative_tolerance = 1e-10, .output_every = 0.01});
  page.expect_energy(run.trajectory, 1e-7);
  page.expect_constraints(run.trajectory, 1e-9);
  const auto speed = run.trajectory[u1];
  const auto [least, most] = std::minmax_element(speed.begin(), speed.end());
  page.expect(*least > 0 && *most > 1.1 * *least, "the flywheel turns on, unevenly");
  return page.show<slider_crank::picture>(run, {.at = 0.05});
}
