// A satellite turns around by spinning its wheels.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace satellite {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"e1"> e1; // the orientation, a unit quaternion
constexpr coordinate<"e2"> e2;
constexpr coordinate<"e3"> e3;
constexpr coordinate<"e0"> e0;
constexpr speed<"w1"> w1; // angular velocity, in the satellite's axes
constexpr speed<"w2"> w2;
constexpr speed<"w3"> w3;
constexpr speed<"s1", radian / second> s1; // spin of the wheels relative to the satellite
constexpr speed<"s2", radian / second> s2;
constexpr speed<"s3", radian / second> s3;
constexpr parameter<"I1", kilogram * pow<2>(meter)> I1;
constexpr parameter<"I2", kilogram * pow<2>(meter)> I2;
constexpr parameter<"I3", kilogram * pow<2>(meter)> I3;
constexpr parameter<"J", kilogram * pow<2>(meter)> J; // of a wheel about its axis
constexpr input<"T1", newton * meter> T1;
constexpr input<"T2", newton * meter> T2;
constexpr input<"T3", newton * meter> T3;

struct N : inertial_frame<N> {};
struct B : quaternion<B, N, e0, e1, e2, e3>, angular_velocity<N, w1 * own::x + w2 * own::y + w3 * own::z> {};
struct W1 : rotated<W1, B, 0, B::x>, angular_velocity<B, s1 * B::x> {};
struct W2 : rotated<W2, B, 0, B::y>, angular_velocity<B, s2 * B::y> {};
struct W3 : rotated<W3, B, 0, B::z>, angular_velocity<B, s3 * B::z> {};
struct O : origin<O, N> {};
struct Hull : rigid_body<Hull, O, B, 60, inertia<B, I1, I2, I3>> {}; // with the wheels, but for their spin
struct Wheel1 : rigid_body<Wheel1, O, W1, 0.0, inertia<B, J, 0, 0>> {};
struct Wheel2 : rigid_body<Wheel2, O, W2, 0.0, inertia<B, 0, J, 0>> {};
struct Wheel3 : rigid_body<Wheel3, O, W3, 0.0, inertia<B, 0, 0, J>> {};

struct System : kane_system<inertial<N>, coordinates<e1, e2, e3, e0>, speeds<w1, w2, w3, s1, s2, s3>,
                            kinematics<kinematics_of<B, N>>, parameters<I1, I2, I3, J>, inputs<T1, T2, T3>,
                            bodies<Hull, Wheel1, Wheel2, Wheel3>,
                            loads<torque_between<W1, B, T1 * B::x>, torque_between<W2, B, T2 * B::y>,
                                  torque_between<W3, B, T3 * B::z>>> {};

constexpr auto momentum =
    (I1 * w1 + J * (w1 + s1)) * B::x + (I2 * w2 + J * (w2 + s2)) * B::y + (I3 * w3 + J * (w3 + s3)) * B::z;

struct C1 : offset<C1, O, 0.36 * B::x> {};
struct C2 : offset<C2, O, 0.36 * B::y> {};
struct C3 : offset<C3, O, 0.46 * B::z> {};
struct LeftPanel : offset<LeftPanel, O, 1.1 * B::y> {};
struct RightPanel : offset<RightPanel, O, -1.1 * B::y> {};
struct Dish : offset<Dish, O, -0.42 * B::z> {};
struct Beam : offset<Beam, O, -0.9 * B::z> {};

using picture = kanexpr::picture<System, up<N::z>, seen_from<N::x - 1.2 * N::y + 0.7 * N::z>,
                                 trace<Beam, colour<"#d98a2b">>,
                                 show<box<B, O, 0.6, 0.6, 0.8>, colour<"#e0b25a">, opacity<0.75>>,
                                 show<box<B, LeftPanel, 0.5, 1.4, 0.02>, colour<"#2f5d8a">>,
                                 show<box<B, RightPanel, 0.5, 1.4, 0.02>, colour<"#2f5d8a">>,
                                 show<wheel<B, C1, B::x, 0.16, 0.06>, spinning<s1 / 20>, colour<"#b5382f">>,
                                 show<wheel<B, C2, B::y, 0.16, 0.06>, spinning<s2 / 20>, colour<"#5d8a4a">>,
                                 show<wheel<B, C3, B::z, 0.16, 0.06>, spinning<s3 / 20>, colour<"#3d6b99">>,
                                 show<cone<B, Dish, -B::z, 0.25, 0.2>, colour<"#c4c8cb">>>;

} // namespace satellite

int main(int count, char** words) {
  using namespace satellite;
  gallery::page page(count, words,
                     {.title = "Satellite with reaction wheels",
                      .kind = "Control",
                      .see = "Three wheels spin up and turn the satellite by 150 degrees, then brake and "
                             "stop with it. No jet fires: the angular "
                             "momentum of satellite and wheels together stays zero.",
                      .source = "Wie, Space Vehicle Dynamics and Control, 2nd edition (2008), chapter 7"});
  const double half = 75 * std::numbers::pi / 180, n = 1 / std::sqrt(3.0);
  const auto run =
      simulate<System>({{e1, n * std::sin(half)},
                        {e2, -n * std::sin(half)},
                        {e3, n * std::sin(half)},
                        {e0, std::cos(half)},
                        {w1, 0},
                        {w2, 0},
                        {w3, 0},
                        {s1, 0},
                        {s2, 0},
                        {s3, 0}},
                       {{I1, 12}, {I2, 8}, {I3, 14}, {J, 0.02}}, {0, 60},
                       {.inputs =
                            [](double, const state<System>& now,
                               input_values<System>& r) { // the opposite of a spring and a damper
                              r[T1] = 0.6 * now[e1] + 3 * now[w1];
                              r[T2] = 0.6 * now[e2] + 3 * now[w2];
                              r[T3] = 0.6 * now[e3] + 3 * now[w3];
                            },
                        .relative_tolerance = 1e-9,
                        .output_every = 0.05});
  double most = 0, wheels = 0;
  for (const Eigen::Vector3d& each : run.trajectory.along<momentum>()) most = std::max(most, each.norm());
  for (const auto& s : run.trajectory) wheels = std::max(wheels, 0.02 * std::abs(s.x[s1]));
  std::printf("ends %g %g %g, wheels %g\n", run.state[e1], run.state[w1], run.state[s1], wheels);
  page.expect_small("the total angular momentum is zero, relative to that of a wheel", most / wheels, 1e-6);
  page.expect(run.state.head(3).norm() < 0.01 && run.state.tail(6).head(3).norm() < 0.01,
              "the satellite comes to rest in the wanted attitude");
  return page.show<satellite::picture>(run, {.names = true});
}
