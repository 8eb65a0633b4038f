// A cart that runs without friction carries five pendulums, one below the other.
#include <kanexpr/simulate.hpp>
#include <models/n_pendulum_cart.hpp>
#include <parts/page.hpp>

namespace n_pendulum_cart {

constexpr auto momentum = m<0> * dot(velocity_of<P<0>>, N::x) + m<1> * dot(velocity_of<P<1>>, N::x) +
                          m<2> * dot(velocity_of<P<2>>, N::x) + m<3> * dot(velocity_of<P<3>>, N::x) +
                          m<4> * dot(velocity_of<P<4>>, N::x) + m<5> * dot(velocity_of<P<5>>, N::x);

template <int i>
using link = show<rod<P<i - 1>, P<i>, 0.012>, colour<"#3d6b99">>;
template <int i>
using bob = show<sphere<P<i>, 0.045>, colour<"#b5382f">>;
using chain_picture =
    kanexpr::picture<System<5>, up<N::y>, seen_from<N::z + 0.3 * N::x + 0.15 * N::y>,
                     trace<P<5>, colour<"#d98a2b">>, show<box<N, P<0>, 0.3, 0.1, 0.15>, colour<"#8f979e">>,
                     link<1>, link<2>, link<3>, link<4>, link<5>, bob<1>, bob<2>, bob<3>, bob<4>, bob<5>>;

} // namespace n_pendulum_cart

int main(int count, char** words) {
  using namespace n_pendulum_cart;
  gallery::page page(
      count, words,
      {.title = "Chain of five pendulums",
       .kind = "Pendulums",
       .see = "The chain is released stretched out to the side, and its end cracks like a whip when it "
              "reaches the bottom. The cart moves back and forth so that the horizontal momentum stays zero.",
       .source = "Kane & Levinson, Dynamics: Theory and Applications (1985); the same system is an example "
                 "of SymPy's mechanics module"});
  using chain = System<5>;
  const auto run = simulate<chain>(
      {{q<0>, 0},
       {q<1>, 0.1},
       {q<2>, 0.05},
       {q<3>, 0},
       {q<4>, -0.05},
       {q<5>, -0.1},
       {u<0>, 0},
       {u<1>, 0},
       {u<2>, 0},
       {u<3>, 0},
       {u<4>, 0},
       {u<5>, 0}},
      {{m<0>, 2},
       {m<1>, 0.2},
       {m<2>, 0.2},
       {m<3>, 0.2},
       {m<4>, 0.2},
       {m<5>, 0.2},
       {l<0>, 0.3},
       {l<1>, 0.3},
       {l<2>, 0.3},
       {l<3>, 0.3},
       {l<4>, 0.3},
       {g, 9.81}},
      {0, 10},
      {.inputs = {{F, 0}}, .relative_tolerance = 1e-10, .absolute_tolerance = 1e-11, .output_every = 0.02});
  page.expect_energy(run.trajectory, 1e-7);
  page.expect_constant("the horizontal momentum", run.trajectory.along<momentum>(), 1, 1e-7);
  return page.show<chain_picture>(run, {.at = 0.4});
}
