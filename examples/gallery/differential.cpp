// The differential of a car whose left wheel is on ice.
#include <kanexpr/joints.hpp>
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace differential {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"J", kilogram * pow<2>(meter)> J;            // of the cage
constexpr parameter<"J_w", kilogram * pow<2>(meter)> Jw;         // of a wheel with its shaft
constexpr parameter<"J_p", kilogram * pow<2>(meter)> Jp;         // of the planet gear about its axis
constexpr parameter<"c_l", newton * meter * second / radian> cl; // resistance of the left wheel
constexpr parameter<"c_r", newton * meter * second / radian> cr; // and of the right one
constexpr input<"T", newton * meter> T;                          // of the engine, on the cage

struct Car : inertial_ground<Car> {}; // y along the axle, to the left
struct Cage : pin<Cage, Car, axis<Car::y>, body<5, 0.0 * own::x, inertia<own, 0, J, 0>>> {};
struct Planet : pin<Planet, Cage, axis<Cage::x>, body<0.2, 0.0 * own::x, inertia<own, Jp, Jp, Jp>>> {};
struct Left : pin<Left, Cage, axis<Cage::y>, body<10, 0.0 * own::x, inertia<own, 0, Jw, 0>>> {};
struct Right : pin<Right, Cage, axis<Cage::y>, body<10, 0.0 * own::x, inertia<own, 0, Jw, 0>>> {};

constexpr auto left_speed = dot(angular_velocity_of<Left>, Car::y);
constexpr auto right_speed = dot(angular_velocity_of<Right>, Car::y);

struct System : kane_system<inertial<Car>, joints<Cage, Planet, Left, Right>,
                            configuration_constraints<gear<Left, Planet, -1>, gear<Right, Planet, 1>>,
                            dependent<q_of<Left>, q_of<Right>, u_of<Left>, u_of<Right>>, inputs<T>,
                            loads<torque<Cage, T * Car::y>, torque<Left, -cl * left_speed * Car::y>,
                                  torque<Right, -cr * right_speed * Car::y>>> {};

template <class Self, class Parent, auto along, auto across = 0.0>
using at_axle = offset<Self, Parent, double(along) * Car::y + double(across) * Parent::z>;
struct LeftWheel : offset<LeftWheel, Car, 0.75 * Car::y> {};
struct RightWheel : offset<RightWheel, Car, -0.75 * Car::y> {};
struct LeftGear : offset<LeftGear, Car, 0.05 * Car::y> {};
struct RightGear : offset<RightGear, Car, -0.05 * Car::y> {};
struct Crown : offset<Crown, Car, 0.2 * Car::y> {};
struct PlanetGear : offset<PlanetGear, Cage, 0.11 * Cage::x> {};
struct CageFront : offset<CageFront, Cage, 0.17 * Cage::x> {};
struct CageBack : offset<CageBack, Cage, -0.17 * Cage::x> {};

using picture =
    kanexpr::picture<System, up<Car::z>, seen_from<0.9 * Car::x + 0.5 * Car::y + 0.5 * Car::z>,
                     show<wheel<Left, LeftWheel, Left::y, 0.32, 0.18>, colour<"#8f979e">>,
                     show<wheel<Right, RightWheel, Right::y, 0.32, 0.18>, colour<"#8f979e">>,
                     show<rod<LeftGear, LeftWheel, 0.025>, colour<"#4b5563">>,
                     show<rod<RightGear, RightWheel, 0.025>, colour<"#4b5563">>,
                     show<cone<Left, Car, Left::y, 0.11, 0.11>, colour<"#3d6b99">, named<"left gear">>,
                     show<cone<Right, Car, -Right::y, 0.11, 0.11>, colour<"#5d8a4a">, named<"right gear">>,
                     show<cone<Planet, Car, Planet::x, 0.11, 0.11>, colour<"#d98a2b">, named<"planet gear">>,
                     show<rod<CageBack, CageFront, 0.02>, colour<"#b5382f">, named<"cage">>,
                     show<ring<Cage, Crown, Cage::y, 0.2, 0.025>, colour<"#b5382f">, named<"crown wheel">>>;

} // namespace differential

int main(int count, char** words) {
  using namespace differential;
  gallery::page page(count, words,
                     {.title = "Differential",
                      .kind = "Mechanisms",
                      .see = "The left wheel is on ice and spins, the right one on asphalt and hardly turns. "
                             "The planet gear shares the torque "
                             "equally, so the wheel with grip gets no more than the one without; its speed "
                             "is always the sum that remains.",
                      .source = "Norton, Design of Machinery, 6th edition (2019), section 9.9"});
  const auto run = simulate<System>({{q_of<Cage>, 0}, {q_of<Planet>, 0}, {u_of<Cage>, 0}, {u_of<Planet>, 0}},
                                    {{J, 0.05}, {Jw, 0.8}, {Jp, 1e-3}, {cl, 0.5}, {cr, 12}}, {0, 8},
                                    {.inputs = {{T, 20}}, .relative_tolerance = 1e-9, .output_every = 0.02});
  page.expect_constraints(run.trajectory, 1e-9);
  const auto left = run.trajectory.along<left_speed>(), right = run.trajectory.along<right_speed>();
  const auto cage = run.trajectory[u_of<Cage>];
  double most = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    most = std::max(most, std::abs(left[i] + right[i] - 2 * cage[i]));
  page.expect_small("the speeds of the wheels add up to twice that of the cage", most, 1e-8);
  std::printf("left %g right %g\n", left.back(), right.back());
  page.expect_small("in the end both wheels receive half of the torque",
                    std::abs(12 * right.back() - 0.5 * left.back()), 0.1);
  return page.show<differential::picture>(run, {.at = 0.5});
}
