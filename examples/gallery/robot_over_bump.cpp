// A robot with four driven wheels crosses a bump with its left wheels.
#include <kanexpr/joints.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/tyres.hpp>
#include <parts/page.hpp>

namespace robot_over_bump {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"m", kilogram> m;                         // of the body
constexpr parameter<"m_w", kilogram> mw;                      // of a wheel
constexpr parameter<"R", meter> R;                            // of the circle of the centers of a tyre's tube
constexpr parameter<"r", meter> r;                            // of the tube
constexpr parameter<"k", newton / meter> k;                   // radial stiffness of a tyre
constexpr parameter<"d", second / meter> d;                   // and its damping
constexpr parameter<"C", newton> C;                           // slip stiffness
constexpr parameter<"Omega", radian / second> desired;        // angular velocity of the wheels
constexpr parameter<"K", newton * meter * second / radian> K; // gain of the motors
constexpr parameter<"h", meter> h;                            // height of the bump
constexpr parameter<"b", meter> b;                            // and its breadth
constexpr parameter<"g", meter / pow<2>(second)> g;

struct N : inertial_ground<N> {}; // z points up
struct Body : floating<Body, N, angles<"zyx">, body<m, 0.0 * own::x, inertia<own, 0.1, 0.2, 0.28>>> {};

template <class Self, auto ahead, auto left>
struct driven : pin<Self, Body, axis<Body::y>, at<ahead * Body::x + left * Body::y - 0.02 * Body::z>,
                    body<mw, 0.0 * own::x, inertia<own, 0.004, 0.007, 0.004>>> {};
struct FL : driven<FL, 0.2, 0.2> {};
struct FR : driven<FR, 0.2, -0.2> {};
struct RL : driven<RL, -0.2, 0.2> {};
struct RR : driven<RR, -0.2, -0.2> {};

constexpr auto bump = [](auto x, auto y) {
  const auto ahead = (x - 1.2) / b, left = (y - 0.15) / b, farther = 1 + ahead * ahead + left * left;
  return h / (farther * farther);
};

template <class Wheel>
using rolling = tyre<toroidal_wheel<Wheel, Body::y, R, r>, uneven_ground<N, N, bump(surface::x, surface::y)>,
                     brush_tyre<0.9, C>, radial_stiffness<k, d, 0.0002>, standstill<0.02>>;
template <class Wheel>
using driving = motor<Wheel, K*(desired - u_of<Wheel>)>;

struct System : kane_system<inertial<N>, joints<Body, FL, FR, RL, RR>,
                            parameters<m, mw, R, r, k, d, C, desired, K, h, b, g>,
                            loads<gravity<-g * N::z>, rolling<FL>, rolling<FR>, rolling<RL>, rolling<RR>,
                                  driving<FL>, driving<FR>, driving<RL>, driving<RR>>> {};

// The ground is drawn as lines.
constexpr double spacing = 0.2;
template <int column, int row>
constexpr auto place_on_ground() {
  constexpr double x = spacing * column - 0.4, y = spacing * row - 0.65;
  return x * N::x + y * N::y + bump(x, y) * N::z;
}
template <int column, int row>
struct on_ground : offset<on_ground<column, row>, N, place_on_ground<column, row>()> {};

constexpr int columns = 18, rows = 8;
template <class>
struct lines;
template <int... each>
struct lines<std::integer_sequence<int, each...>> {
  template <int row>
  using along = cable<0.003, on_ground<each, row>...>;
  template <int column>
  using across = cable<0.003, on_ground<column, each>...>;
};
template <int row>
using along = show<typename lines<std::make_integer_sequence<int, columns>>::template along<row>,
                   colour<"#9fb4c8">, named<"ground">>;
template <int column>
using across = show<typename lines<std::make_integer_sequence<int, rows>>::template across<column>,
                    colour<"#9fb4c8">, named<"ground">>;

template <class Wheel>
using tyre_of = show<ring<Wheel, Wheel, Wheel::y, R + r, 2 * r>, colour<"#33383d">>;
template <class Wheel>
using rim_of = show<cylinder<Wheel, Wheel, Wheel::y, R, r>, colour<"#8f979e">>;

template <class>
struct drawn;
template <int... row, int... column>
struct drawn<std::pair<std::integer_sequence<int, row...>, std::integer_sequence<int, column...>>> {
  using picture = kanexpr::picture<System, up<N::z>, seen_from<-0.4 * N::x - 1.1 * N::y + 0.7 * N::z>,
                                   show<box<Body, Body, 0.5, 0.28, 0.1>, colour<"#b5382f">, named<"body">>,
                                   tyre_of<FL>, tyre_of<FR>, tyre_of<RL>, tyre_of<RR>, rim_of<FL>, rim_of<FR>,
                                   rim_of<RL>, rim_of<RR>, along<row>..., across<column>...>;
};
using picture = drawn<
    std::pair<std::make_integer_sequence<int, rows>, std::make_integer_sequence<int, columns>>>::picture;

} // namespace robot_over_bump

int main(int count, char** words) {
  using namespace robot_over_bump;
  gallery::page page(
      count, words,
      {.title = "Robot over a bump",
       .kind = "Vehicles",
       .see = "The robot drives over a bump with its left wheels. Its tyres are tori on the ground z = f(x, "
              "y); their forces lift the body, and the slip of the wheels turns it aside.",
       .source = "Pacejka, Tire and Vehicle Dynamics (2012), section 3.2"});
  const double at_rest = 0.02 + 0.12 - 14 * 9.81 / 4 / 15000; // 9.81 * 14 N on four springs
  equations_of_motion<System>::state start;
  start[q_of<Body, 3>] = at_rest;
  const auto run = simulate<System>(start,
                                    {{m, 10},
                                     {mw, 1},
                                     {R, 0.085},
                                     {r, 0.035},
                                     {k, 15000},
                                     {d, 2.5},
                                     {C, 800},
                                     {desired, 8},
                                     {K, 1},
                                     {h, 0.1},
                                     {b, 0.35},
                                     {g, 9.81}},
                                    {0, 3}, {.relative_tolerance = 1e-8, .output_every = 0.01});
  double highest = 0, lean = 0;
  for (const auto& s : run.trajectory) {
    highest = std::max(highest, s.x[q_of<Body, 3>]);
    lean = std::max(lean, s.x[q_of<Body, 6>]);
  }
  std::printf("as high as %g m, leaning by %g rad; at last turned by %g rad\n", highest - at_rest, lean,
              run.state[q_of<Body, 4>]);
  page.expect(highest > at_rest + 0.03 && highest < at_rest + 0.1, "the bump lifts the body");
  page.expect(lean > 0.1 && lean < 0.3, "the body leans to the right");
  page.expect_small("behind the bump, the body is as high as at rest", run.state[q_of<Body, 3>] - at_rest,
                    1e-3);
  page.expect(run.state[q_of<Body, 1>] > 2, "the robot crosses the bump");
  return page.show<robot_over_bump::picture>(run, {.at = 1.5});
}
