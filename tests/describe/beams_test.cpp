// builds: clang++ all
// Beams from words: the same systems as those from a builder.
#include "systems/beams.hpp"

#include <kanexpr/beams.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/numeric/beams/tables.hpp>

#include <string>
#include <vector>

namespace {

using namespace beams;
using kanexpr::numeric::beams::shape;
using kanexpr::runtime::beam_data;
using kanexpr::runtime::beam_id;
using kanexpr::runtime::modes_of_bending;
using kanexpr::runtime::modes_of_rod;
using kanexpr::runtime::section_ids;
using mechanics::quantity;

namespace words {
using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct R : rotated<R, N, q, N::z> {};
struct Root : offset<Root, O, 0.3 * R::x> {};
struct Blade : beam<Blade, Root, R::x, 1.7, 0.6, profile<stations<0, 1, 0.4, 0.8, 1, 0.5>>,
                    bending<R::y, 3.1, clamped_free<2>, profile<polynomial<1, -0.6>>>,
                    bending<R::z, 2.0, stations<0, 0, 0.3, 0.1, 0.7, 0.5, 1, 1>>,
                    torsion<7.0, polar_inertia<0.02, profile<polynomial<1, -0.5>>>, clamped_free<1>>,
                    extension<50.0, polynomial<0, 2, -1>>, proportional_damping<0.1, 0.002>> {};
struct Middle : section<Middle, Blade, 0.5> {};
struct Tip : section<Tip, Blade, 1> {};
struct Second
    : beam<Second, Tip, Tip::y, 0.9, 0.4, bending<Tip::x, 1.0, stations_with_slopes<0, 0, 0, 1, 1, 1.5>>,
           modal_damping<0.02>, by<coordinate<"a">{}, speed<"b">{}>> {};
struct End : section<End, Second, 1> {};
struct Arm : pin<Arm, Middle, axis<own::y>, body<0.3, 0.2 * own::x>> {};
struct Load : particle<Load, End, 0.25> {};
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, joints<Arm>,
                            bodies<Blade, Second, Load>, loads<gravity<-9.81 * N::y>>> {};
} // namespace words

// The same system, built.
struct built_words : bench {
  built_words() {
    const expression q = add("q", "u"), arm = add("q_Arm", "u_Arm");
    std::vector<expression> blade;
    for (int i = 1; i <= 5; ++i)
      blade.push_back(add("q" + std::to_string(i) + "_Blade", "u" + std::to_string(i) + "_Blade"));
    const expression second = add("a", "b");
    const frame_id r = rotated("R", n, q, along(n, 0, 0, 1));
    beam_data data{.axis = along(r, 1, 0, 0), .length = 1.7, .mass_per_length = 0.6};
    data.mass_profile = kanexpr::numeric::beams::linear_table({0.0, 0.4, 1.0}, {1.0, 0.8, 0.5});
    const shape splined = kanexpr::numeric::beams::spline({0.0, 0.3, 0.7, 1.0}, {0.0, 0.1, 0.5, 1.0}, true);
    data.bending = {
        {along(r, 0, 1, 0), {3.1, modes_of_bending(ends::clamped_free, 2), shape::polynomial({1.0, -0.6})}},
        {along(r, 0, 0, 1), {2.0, {splined}}}};
    data.torsion = {.polar_inertia = 0.02,
                    .by = {7.0, modes_of_rod(ends::clamped_free, 1)},
                    .profile = shape::polynomial({1.0, -0.5})};
    data.extension = {50.0, {shape::polynomial({0.0, 2.0, -1.0})}};
    data.damping_of_mass = 0.1, data.damping_of_stiffness = 0.002;
    const beam_id first = beam("Blade", offset("Root", o, along(r, 0.3, 0, 0)), r, blade, data);
    const section_ids middle = section("Middle", first, 0.5), tip = section("Tip", first, 1);
    const shape cubic = kanexpr::numeric::beams::cubic_table({0.0, 1.0}, {0.0, 1.0}, {0.0, 1.5});
    beam_data other{.axis = along(tip.frame, 0, 1, 0), .length = 0.9, .mass_per_length = 0.4};
    other.bending = {{along(tip.frame, 1, 0, 0), {1.0, {cubic}}}};
    other.damping_ratios = {0.02};
    const section_ids end = section("End", beam("Second", tip.point, tip.frame, {second}, other), 1);
    const frame_id turned = rotated("Arm", middle.frame, arm, along(middle.frame, 0, 1, 0));
    particle("Load", end.point, number(0.25));
    particle("Arm", offset("C", middle.point, along(turned, 0.2, 0, 0)), number(0.3));
    gravity(along(n, 0, -9.81, 0));
  }
  expression add(const std::string& q, const std::string& u) {
    const expression e = coordinate(q);
    kinematic_equation(dot(e) - speed(u));
    return e;
  }
};

TEST(beam_words, describe_the_same_system_as_a_builder) {
  kanexpr::model found = kanexpr::derive<words::System>();
  ASSERT_EQ(found.mistake(), "");
  built_words by_hand;
  ASSERT_EQ(by_hand.check().view(), "");
  kanexpr::model expected = kanexpr::derive(by_hand);
  EXPECT_EQ(found.linearize().states(), expected.linearize().states());
  for (const unsigned seed : {1u, 2u}) {
    values now = random_values(8, 8, seed);
    now.q *= 0.3;
    for (const quantity each :
         {quantity::mass_matrix, quantity::forcing, quantity::kinetic_energy, quantity::potential_energy})
      expect_equal(now.of(found.get(each)), now.of(expected.get(each)),
                   std::string(mechanics::row_of(each).called));
  }
}

TEST(beam_words, name_the_symbols) {
  const std::vector<std::string> expected{
      "q", "q_Arm", "q1_Blade", "q2_Blade", "q3_Blade", "q4_Blade", "q5_Blade", "a",
      "u", "u_Arm", "u1_Blade", "u2_Blade", "u3_Blade", "u4_Blade", "u5_Blade", "b"};
  EXPECT_EQ(kanexpr::derive<words::System>().linearize().states(), expected);
}

// Free and pinned modes as words: a beam that floats in the plane.
namespace floating_beam {
using namespace kanexpr;
struct Ground : inertial_ground<Ground> {};
struct Base : planar<Base, Ground, axis<own::x, own::y>> {};
struct Rod : beam<Rod, Base, Base::x, 1.7, 0.6, bending<Base::y, 3.1, free_free<2>>> {};
struct System : kane_system<inertial<Ground>, joints<Base>, bodies<Rod>> {};
struct ByLagrange : lagrange_system<inertial<Ground>, joints<Base>, bodies<Rod>> {};
} // namespace floating_beam

// Beams of a template, whose arguments differ only in sign.
namespace panels {
using namespace kanexpr;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
template <int side>
struct Panel : beam<Panel<side>, O, side * N::x, 1.7, 0.6, bending<N::y, 3.1, clamped_free<1>>> {};
struct System : kane_system<inertial<N>, bodies<Panel<1>, Panel<-1>>> {};
} // namespace panels

TEST(beam_words, name_the_amplitudes_of_templates_by_their_arguments) {
  kanexpr::model m = kanexpr::derive<panels::System>();
  ASSERT_EQ(m.mistake(), "");
  const std::vector<std::string> expected{"q_Panel_1", "q_Panel_minus1", "u_Panel_1", "u_Panel_minus1"};
  EXPECT_EQ(m.linearize().states(), expected);
}

TEST(beam_words, describe_a_floating_beam) {
  expect_frequencies(kanexpr::derive<floating_beam::System>(), rates_of(ends::free_free, 2), "free-free");
}

TEST(beam_words, give_the_same_equations_by_lagranges_method) {
  const values now = random_values(5, 5, 4);
  kanexpr::model kane = kanexpr::derive<floating_beam::System>(),
                 lagrange = kanexpr::derive<floating_beam::ByLagrange>();
  ASSERT_EQ(lagrange.mistake(), "");
  for (const quantity each : {quantity::mass_matrix, quantity::forcing})
    expect_equal(now.of(lagrange.get(each)), now.of(kane.get(each)),
                 std::string(mechanics::row_of(each).called));
}

TEST(beam_words, compile_to_the_interpreted_equations) {
  using eom = kanexpr::equations_of_motion<floating_beam::System>;
  const values now = random_values(5, 5, 9);
  eom::state x;
  for (int i = 0; i < 5; ++i) x[i] = now.q[i], x[5 + i] = now.u[i];
  const VectorXd found = eom::udot(x), expected = now.of(kanexpr::derive<floating_beam::System>().udot());
  EXPECT_EQ(found, expected);
}

} // namespace
