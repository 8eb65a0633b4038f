// A railway wheelset that runs too fast begins to hunt.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>

namespace wheelset {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"y", meter> y;      // across the track
constexpr coordinate<"psi", radian> psi; // yaw
constexpr speed<"v"> v;
constexpr speed<"omega"> omega;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"I", kilogram * pow<2>(meter)> I;
constexpr parameter<"V", meter / second> V; // speed of the vehicle
constexpr parameter<"b", meter> b;          // half of the distance between the rails
constexpr parameter<"r", meter> r;          // radius of the wheels
constexpr parameter<"gamma", dimensionless> conicity;
constexpr parameter<"f", newton> f;            // creep coefficient
constexpr parameter<"k_y", newton / meter> ky; // suspension
constexpr parameter<"k_psi", newton * meter / radian> kpsi;
constexpr parameter<"k_3", newton / pow<3>(meter)> k3; // flanges

struct N : inertial_frame<N> {}; // moves with the vehicle; x points ahead, z up
struct A : rotated<A, N, psi, N::z> {};
struct O : origin<O, N> {};
struct G : offset<G, O, y * N::y> {};

// Kalker's linear creep forces at both wheels, for lateral motion and yaw.
constexpr auto lateral = -2 * f * (v / V - psi) - ky * y - k3 * y * y * y;
constexpr auto yawing = -2 * f * b * (conicity * y / r + b * omega / V) - kpsi * psi;

struct Wheelset : rigid_body<Wheelset, G, A, m, inertia<A, I, 0, I>> {};
struct System : kane_system<inertial<N>, coordinates<y, psi>, speeds<v, omega>, kinematics<simple>,
                            parameters<m, I, V, b, r, conicity, f, ky, kpsi, k3>, bodies<Wheelset>,
                            loads<force<G, lateral * N::y>, torque<A, yawing * N::z>>> {};

// The picture shows the motion twenty times larger.
constexpr int larger = 20;
struct Axle : rotated<Axle, N, larger * psi, N::z> {};
struct Middle : offset<Middle, O, larger * y * N::y> {};
struct Left : offset<Left, Middle, b * Axle::y> {};
struct Right : offset<Right, Middle, -b * Axle::y> {};
template <class Self, auto side, auto ahead>
struct on_rail : offset<Self, O, double(ahead) * N::x + double(side) * b * N::y - (r + 0.04) * N::z> {};
struct LF : on_rail<LF, 1, 3> {};
struct LB : on_rail<LB, 1, -3> {};
struct RF : on_rail<RF, -1, 3> {};
struct RB : on_rail<RB, -1, -3> {};

template <class P>
using turning_wheel = show<wheel<Axle, P, Axle::y, r, 0.12>, spinning<V / r / 10>, colour<"#8f979e">>;
using rail = colour<"#7b8794">;

using picture = kanexpr::picture<
    System, up<N::z>, ground<-0.55>, seen_from<-N::x - 0.55 * N::y + 0.6 * N::z>, turning_wheel<Left>,
    turning_wheel<Right>, show<rod<Left, Right, 0.09>, colour<"#4b5563">>,
    show<rod<LB, LF, 0.04>, rail, named<"left rail">>, show<rod<RB, RF, 0.04>, rail, named<"right rail">>>;

} // namespace wheelset

int main(int count, char** words) {
  using namespace wheelset;
  gallery::page page(
      count, words,
      {.title = "Railway wheelset",
       .kind = "Vehicles",
       .see = "At 55 m/s the wheelset swings from rail to rail, here drawn twenty times larger: it hunts, "
              "and only the "
              "flanges hold it. Below its critical speed of 41 m/s, the conical wheels and the springs bring "
              "it back "
              "to the middle of the track.",
       .source = "Klingel, Organ für die Fortschritte des Eisenbahnwesens 38 (1883), pages 113-123; Wickens, "
                 "Fundamentals of Rail Vehicle Dynamics (2003), chapter 3"});
  const auto at_speed = [](double speed) {
    return simulate<System>({{y, 0.003}, {psi, 0}, {v, 0}, {omega, 0}},
                            {{m, 1250},
                             {I, 700},
                             {V, speed},
                             {b, 0.75},
                             {r, 0.45},
                             {conicity, 0.15},
                             {f, 7.5e6},
                             {ky, 2e5},
                             {kpsi, 1e6},
                             {k3, 2e10}},
                            {0, 6}, {.relative_tolerance = 1e-8, .output_every = 0.005});
  };
  const auto largest_in = [](const auto& path, double from, double to) {
    double most = 0;
    for (const auto& s : path)
      if (s.t >= from && s.t <= to) most = std::max(most, std::abs(s.x[y]));
    return most;
  };
  const auto run = at_speed(55), slow = at_speed(25);
  const double late = largest_in(run.trajectory, 5, 6);
  page.expect(largest_in(slow.trajectory, 5, 6) < 1e-4,
              "at 25 m/s the wheelset returns to the middle of the track");
  page.expect(late > 0.004 && late < 0.02, "at 55 m/s the wheelset hunts");
  page.expect_small("it hunts with a steady amplitude", std::abs(late / largest_in(run.trajectory, 4, 5) - 1),
                    0.01);
  return page.show<wheelset::picture>(run, {.upward = Eigen::Vector3d(0, 0, 1)});
}
