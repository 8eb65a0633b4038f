// A body on a spring that couples its stretch to its twist.
#include <kanexpr/joints.hpp>
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace wilberforce {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"z", meter> z;
constexpr coordinate<"theta", radian> theta;
constexpr speed<"v"> v;
constexpr speed<"omega"> omega;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"k", newton / meter> k;                  // stiffness against stretching
constexpr parameter<"delta", newton * meter / radian> delta; // and against twisting
constexpr parameter<"epsilon", newton / radian> epsilon;     // their coupling

struct N : inertial_frame<N> {}; // z points up; z = 0 where the weight is balanced
struct B : rotated<B, N, theta, N::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, z * N::z> {};
struct Weight : rigid_body<Weight, G, B, m, inertia<B, I, I, I>> {};

struct System
    : kane_system<inertial<N>, coordinates<z, theta>, speeds<v, omega>, kinematics<simple>, bodies<Weight>,
                  loads<potential_energy<(k * z * z + delta * theta * theta + epsilon * z * theta) / 2>>> {};

struct Support : offset<Support, O, 0.45 * N::z> {};
struct Top : offset<Top, G, 0.04 * N::z> {};
template <class Self, auto side>
struct Arm : offset<Self, G, double(side) * 0.055 * B::x> {};
struct Left : Arm<Left, -1> {};
struct Right : Arm<Right, 1> {};

using picture = kanexpr::picture<System, up<N::z>, seen_from<N::x - 1.6 * N::y + 0.5 * N::z>,
                                 show<box<N, Support, 0.16, 0.1, 0.012>, colour<"#8f979e">>,
                                 show<coil<Support, Top, 0.016, 26>, colour<"#7b8794">>,
                                 show<cylinder<B, G, B::z, 0.025, 0.08>, colour<"#b5382f">>,
                                 show<rod<Left, Right, 0.004>, colour<"#3d6b99">>,
                                 show<sphere<Left, 0.012>, colour<"#3d6b99">>,
                                 show<sphere<Right, 0.012>, colour<"#3d6b99">>>;

} // namespace wilberforce

int main(int count, char** words) {
  using namespace wilberforce;
  gallery::page page(
      count, words,
      {.title = "Wilberforce pendulum",
       .kind = "Pendulums",
       .see = "The weight bounces up and down, then stops bouncing and twists instead, and then bounces "
              "again. Both frequencies are equal, so the weak coupling of the spring moves all energy "
              "from one motion to the other.",
       .source = "Berg & Marshall, Wilberforce pendulum oscillations and normal modes, American Journal of "
                 "Physics 59 (1991), pages 32-38, with the values measured there"});
  const auto run =
      simulate<System>({{z, 0.1}, {theta, 0}, {v, 0}, {omega, 0}},
                       {{m, 0.4905}, {I, 1.39e-4}, {k, 2.8}, {delta, 7.86e-4}, {epsilon, 9.27e-3}}, {0, 60},
                       {.relative_tolerance = 1e-10, .output_every = 0.05});
  page.expect_energy(run.trajectory, 1e-7);
  double least = 1; // energy of the bouncing, relative to that at the start
  for (const auto& s : run.trajectory)
    least = std::min(least, (0.4905 * s.x[v] * s.x[v] + 2.8 * s.x[z] * s.x[z]) / (2.8 * 0.01));
  page.expect(least < 0.02, "the energy of bouncing passes to the twist, except for less than 2 percent");
  return page.show<wilberforce::picture>(run, {.at = 0.4});
}
