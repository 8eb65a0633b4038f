// builds: clang++ all
// Loops that are closed by more equations than necessary.
#include <kanexpr/assemble.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/simulations/model.hpp>

#include <Eigen/QR>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
using mechanics::vector;
using runtime::builder;
using runtime::frame_id;
using runtime::point_id;
using symbolic::expression;

class linkage : public builder {
public:
  linkage() : builder("N") {}

protected:
  expression angle(int i) {
    const std::string k = std::to_string(i);
    const expression q = coordinate("q" + k);
    kinematic_equation(dot(q) - speed("u" + k));
    return q;
  }
  /// A rod of 1 m and 1 kg, round and thin.
  void rod(const std::string& called, frame_id f, point_id from, const vector& to_middle, int along_axis) {
    const point_id center = offset("G" + called, from, to_middle);
    const double across = 1.0 / 12, along_it = 1e-3;
    const expression i[3]{number(along_axis == 0 ? along_it : across),
                          number(along_axis == 1 ? along_it : across),
                          number(along_axis == 2 ? along_it : across)};
    rigid_body(called, center, f, number(1), inertia(f, i[0], i[1], i[2]));
  }
};

/// A bead in a plane.
struct bead_in_a_plane : builder {
  expression x = coordinate("x"), y = coordinate("y");
  bead_in_a_plane() : builder("N") {
    const expression u = speed("u"), v = speed("v");
    kinematic_equation(dot(x) - u);
    kinematic_equation(dot(y) - v);
    particle("Bead", offset("P", origin("O"), along(inertial_frame(), x, y, 0)), number(1));
  }
};

/// A bead with z = x² on a cylinder about z: neither constraint follows from the other.
struct bead_in_a_bowl : builder {
  explicit bead_in_a_bowl(bool has_parameter) : builder("N") {
    const expression x = coordinate("x"), y = coordinate("y"), z = coordinate("z");
    kinematic_equation(dot(x) - speed("vx"));
    kinematic_equation(dot(y) - speed("vy"));
    kinematic_equation(dot(z) - speed("vz"));
    particle("Bead", offset("P", origin("O"), along(inertial_frame(), x, y, z)), number(1));
    const expression l = has_parameter ? parameter("l") : number(1);
    configuration_constraint(x * x + y * y - l * l);
    configuration_constraint(z - x * x / l);
    redundant(2);
    gravity(along(inertial_frame(), 0, 0, -9.81));
  }
};

/// A four-bar linkage; in space it is closed by all five equations of a hinge.
class four_bar : public linkage {
public:
  four_bar(bool in_space, std::initializer_list<int> left_out = {}) {
    frame_id f = inertial_frame();
    point_id at = origin("O");
    const double lengths[]{1, 2.5, 2};
    for (int i = 0; i < 3; ++i) {
      const std::string k = std::to_string(i);
      f = rotated("F" + k, f, angle(i + 1), along(f, 0, 0, 1));
      rod("Rod" + k, f, at, along(f, lengths[i] / 2, 0, 0), 0);
      at = offset("P" + k, at, along(f, lengths[i], 0, 0));
    }
    const frame_id n = inertial_frame();
    const vector gap = position_of(at, offset("Bearing", point_id{0}, along(n, 3, 0, 0)));
    configuration_constraint(dot(gap, along(n, 1, 0, 0)));
    configuration_constraint(dot(gap, along(n, 0, 1, 0)));
    if (in_space) {
      configuration_constraint(dot(gap, along(n, 0, 0, 1)));
      configuration_constraint(dot(along(f, 0, 0, 1), along(n, 1, 0, 0)));
      configuration_constraint(dot(along(f, 0, 0, 1), along(n, 0, 1, 0)));
    }
    for (const int each : left_out) redundant(each);
    gravity(along(n, 0, -9.81, 0));
  }
};

TEST(redundant_constraints, are_named_by_the_sentence_that_rejects_them) {
  EXPECT_EQ(
      derive(four_bar(true)).mistake(),
      "configuration constraints 3, 4 and 5 contain no coordinate; add redundant<3, 4, 5> to drop them");
  EXPECT_EQ(derive(four_bar(true, {3, 5})).mistake(),
            "configuration constraint 4 contains no coordinate; add redundant<4> to drop it");
  EXPECT_EQ(derive(four_bar(false, {3})).mistake(),
            "redundant<3> is out of range: the model has 2 configuration constraints");
  EXPECT_EQ(derive(four_bar(true, {3, 3})).mistake(),
            "configuration constraint 3 is listed twice in redundant<...>");
}

TEST(redundant_constraints, of_a_planar_loop_in_space_leave_its_motion) {
  const std::initializer_list<named_value> start{{"q1", 1.2}, {"q2", -1}, {"q3", -1.8},
                                                 {"u1", 2},   {"u2", 0},  {"u3", 0}};
  simulation_options<model> options{.guesses_dependent = true, .relative_tolerance = 1e-11};
  const auto planar = simulate(derive(four_bar(false)), start, {}, {0, 3}, options);
  const auto spatial = simulate(derive(four_bar(true, {3, 4, 5})), start, {}, {0, 3}, options);
  ASSERT_TRUE(planar) << planar.cause();
  ASSERT_TRUE(spatial) << spatial.cause();
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(planar.state(i), spatial.state(i), 1e-9);
}

/// Bricard's loop of six hinges between rods of 1 m, each perpendicular to the next, as in IFToMM's library
/// of benchmarks. Five hinges are angles; the sixth closes the loop with five equations, although four would
/// suffice. `turns` makes the last hinge an angle too; then six equations close the loop.
class bricard : public linkage {
public:
  explicit bricard(bool turns, std::initializer_list<int> left_out = {}) {
    constexpr int axis_of_hinge[]{1, 0, 2, 1, 0, 2};
    // the directions of the rods in the closed position, seen from the hinges between them
    constexpr std::array<std::array<int, 3>, 5> ways{
        {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
    const frame_id n = inertial_frame();
    frame_id f = n;
    point_id at = offset("Start", origin("O"), along(n, 1, 0, 0));
    for (int i = 0; i < 5; ++i) {
      const std::string k = std::to_string(i);
      const auto [x, y, z] = ways[static_cast<std::size_t>(i)];
      f = rotated("F" + k, f, angle(i + 1), unit(f, axis_of_hinge[i]));
      rod("Rod" + k, f, at, along(f, 0.5 * x, 0.5 * y, 0.5 * z), x != 0 ? 0 : y != 0 ? 1 : 2);
      at = offset("P" + k, at, along(f, x, y, z));
    }
    const vector gap = position_of(at, point_id{0});
    for (int i = 0; i < 3; ++i) configuration_constraint(dot(gap, unit(n, i)));
    if (turns) { // a body that does not move where the loop is closed
      f = rotated("F5", f, angle(6), unit(f, axis_of_hinge[5]));
      rod("Rod5", f, at, along(f, 0.5, 0, 0), 0);
    }
    const int axis = axis_of_hinge[5], next = (axis + 1) % 3, last = (axis + 2) % 3;
    configuration_constraint(dot(unit(f, axis), unit(n, next)));
    configuration_constraint(dot(unit(f, axis), unit(n, last)));
    if (turns) configuration_constraint(dot(unit(f, next), unit(n, last)));
    for (const int each : left_out) redundant(each);
    gravity(along(n, 0, -9.81, 0));
  }

private:
  vector unit(frame_id f, int axis) {
    return along(f, axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
  }
};

std::vector<named_value> at_rest(bool turns) {
  std::vector<named_value> all;
  for (int i = 1; i <= (turns ? 6 : 5); ++i)
    for (const char* each : {"q", "u"}) all.push_back({each + std::to_string(i), 0});
  return all;
}

TEST(redundant_constraints, of_bricards_loop) {
  for (const bool turns : {false, true})
    EXPECT_EQ(derive(bricard(turns)).mistake(),
              "the constraints determine every speed, so nothing can move; where all hold, configuration "
              "constraint 5 follows from the preceding ones; add redundant<5> to drop it");
  // Any of the six equations may be omitted if the others do not imply its independence; any of five may be.
  const auto moved = [](bool turns, int left_out) {
    const auto run = simulate(derive(bricard(turns, {left_out})), at_rest(turns), {}, {0, 1},
                              {.relative_tolerance = 1e-11});
    EXPECT_TRUE(run) << left_out << ": " << run.cause();
    return run.state;
  };
  const state<model> by_five = moved(false, 5);
  EXPECT_GT(std::abs(by_five["q1"]), 0.1);
  for (const char* other : {"q3", "q5"})
    EXPECT_NEAR(by_five[other], by_five["q1"], 1e-8); // as all of them have it
  for (int left_out = 1; left_out <= 5; ++left_out)
    for (const bool turns : {false, true}) {
      const state<model> other = moved(turns, left_out);
      for (const char* each : {"q1", "q2", "q3", "q4", "q5", "u1", "u2", "u3", "u4", "u5"})
        EXPECT_NEAR(other[each], by_five[each], 1e-8) << left_out;
    }
}

/// The rows that a model uses and those that it omits, in the original order.
std::vector<int> order_of_rows(int rows, int left_out) {
  std::vector<int> order;
  for (int i = 1; i <= rows; ++i)
    if (i != left_out) order.push_back(i - 1);
  order.push_back(left_out - 1);
  return order;
}

// Regardless of the omitted row, the forces that close the loop are distributed over all rows.
TEST(redundant_constraints, share_the_multipliers_of_minimum_norm) {
  const auto run =
      simulate(derive(bricard(true, {5})), at_rest(true), {}, {0, 0.7}, {.relative_tolerance = 1e-12});
  ASSERT_TRUE(run) << run.cause();
  constexpr int rows = 6, speeds = 6;
  const auto found_without = [&](int left_out) {
    model m = derive(bricard(true, {left_out}));
    Eigen::VectorXd x = run.state;
    EXPECT_TRUE(assemble(m, x));
    auto found = find_least_multipliers(m, x);
    EXPECT_EQ(found.cause(), "");
    EXPECT_EQ(found.constraints.rank, 5);
    EXPECT_EQ(found.constraints.cause(), "redundant constraint 1 depends on other constraints at this state");
    // J and M of the model, and the minimum-norm solution by Eigen
    const auto value = [&](mechanics::quantity of) -> Eigen::MatrixXd {
      return m.function(m.get(of))(x, Eigen::VectorXd(), Eigen::VectorXd());
    };
    using mechanics::quantity;
    Eigen::MatrixXd j(rows, speeds);
    j << value(quantity::constraint_jacobian), value(quantity::redundant_jacobian);
    EXPECT_LT((j.bottomRows(1) * found.udot + value(quantity::redundant_bias)).norm(), 1e-12);
    const Eigen::VectorXd force =
        value(quantity::unreduced_mass_matrix) * found.udot - value(quantity::unreduced_forcing);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> by_eigen;
    by_eigen.setThreshold(1e-8);
    const Eigen::VectorXd expected = by_eigen.compute(j.transpose()).solve(force);
    EXPECT_LT((found.multipliers - expected).norm(), 1e-12 * expected.norm());
    Eigen::VectorXd in_order(rows);
    const std::vector<int> order = order_of_rows(rows, left_out);
    for (int i = 0; i < rows; ++i) in_order(order[static_cast<std::size_t>(i)]) = found.multipliers(i);
    found.multipliers = in_order;
    return found;
  };
  const auto first = found_without(5);
  EXPECT_GT(first.multipliers.norm(), 1);
  for (const int other : {1, 4}) {
    const auto found = found_without(other);
    EXPECT_LT((found.udot - first.udot).norm(), 1e-12);
    EXPECT_LT((found.multipliers - first.multipliers).norm(), 1e-12 * first.multipliers.norm());
  }
}

namespace sliding {

constexpr coordinate<"x"> x;
constexpr coordinate<"y"> y;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y> {};
struct Bead : particle<Bead, P, 1> {};
struct System
    : kane_system<inertial<N>, coordinates<x, y>, speeds<u, v>, kinematics<dot(x) == u, dot(y) == v>,
                  configuration_constraints<x == y, x * x == y * y>, redundant<2>, dependent<y, v>,
                  bodies<Bead>, loads<gravity<-9.81 * N::y>>> {};

} // namespace sliding

// A redundant constraint is not solved for anything, but states are checked against it.
TEST(redundant_constraints, are_checked_at_states) {
  using sliding::System;
  state<System> at{{sliding::x, 1}, {sliding::y, 1}, {sliding::u, 2}, {sliding::v, 2}};
  EXPECT_TRUE(check_consistency<System>(at));
  EXPECT_NEAR((equations_of_motion<System>::udot(at)[0]), -9.81 / 2, 1e-12);
  at[sliding::y] = -1;
  EXPECT_EQ(check_consistency<System>(at).cause(), "configuration constraint 1 has a residual of 2");
  model m = derive<System>();
  EXPECT_EQ(m.get(mechanics::quantity::redundant_residual).rows, 1);
}

// Constraints that are declared redundant but do not follow: found during derivation if all numbers are
// known.
TEST(redundant_constraints, that_restrict_the_motion_are_rejected) {
  bead_in_a_plane across;
  across.configuration_constraint(across.x - across.y);
  across.configuration_constraint(across.x + across.y - 2);
  across.redundant(1);
  EXPECT_EQ(derive(across).mistake(), "configuration constraint 1 does not follow from the others, so it is "
                                      "not redundant; remove redundant<1>");
  // A bead in a bowl that is curved in one direction, on a cylinder.
  EXPECT_EQ(derive(bead_in_a_bowl(false)).mistake(), "configuration constraint 2 does not follow from the "
                                                     "others, so it is not redundant; remove redundant<2>");
}

// If this depends on values of parameters, such as equal lengths of bars, it is found when states are known.
TEST(redundant_constraints, that_do_not_hold_are_reported) {
  bead_in_a_plane b;
  b.configuration_constraint(b.x - b.y);
  const expression k = b.parameter("l"); // at 1 they follow from each other
  b.configuration_constraint(b.x - k * b.y + k - 1);
  b.redundant(2);
  model m = derive(b);
  Eigen::VectorXd at(4), l(1);
  at << 3, 3, 0.5, 0.5;
  l << 1;
  EXPECT_TRUE(assemble(m, at, l));
  l << 2;
  EXPECT_EQ(assemble(m, at, l).cause(), "redundant constraint 1 has a residual of -2");
  const consistency placed = check_consistency(m, at, l, Eigen::VectorXd());
  EXPECT_EQ(placed.cause(), "redundant constraint 1 has a residual of -2");
  EXPECT_EQ(placed.configuration_residual, 2);
  at << 1, 1, 0.5, 0.5;
  EXPECT_EQ(assemble(m, at, l).cause(), "the rate of redundant constraint 1 has a residual of -0.5");
  const consistency moving = check_consistency(m, at, l, Eigen::VectorXd());
  EXPECT_EQ(moving.cause(), "the rate of redundant constraint 1 has a residual of -0.5");
  EXPECT_EQ(moving.velocity_residual, 0.5);
}

template <integrator by>
void leaves_no_bowl() {
  const auto moved = [](double vz) {
    return simulate<by>(derive(bead_in_a_bowl(true)),
                        {{"x", 0.6}, {"y", 0.8}, {"z", 0.36}, {"vx", 0.8}, {"vy", -0.6}, {"vz", vz}},
                        {{"l", 1}}, {0, 0.5});
  };
  const auto run = moved(0.96);
  EXPECT_THAT(run.cause(), testing::HasSubstr(": redundant constraint 1 has a residual of "));
  EXPECT_THAT(run.cause(), testing::HasSubstr(": it does not follow from the other constraints"));
  EXPECT_LT(run.time, 0.05);
  EXPECT_GT(run.trajectory.constraint_residuals().back(), 1e-6);
  EXPECT_EQ(
      moved(1.96).cause(),
      "the simulation ended at t = 0 with x = 0.6, y = 0.8, z = 0.36, vx = 0.8, vy = -0.6, vz = 1.96: the "
      "rate of redundant constraint 1 has a residual of 1");
}

TEST(redundant_constraints, that_do_not_follow_end_simulations) {
  leaves_no_bowl<integrator::adams>();
  leaves_no_bowl<integrator::explicit_runge_kutta>();
  leaves_no_bowl<integrator::bdf>();
  leaves_no_bowl<integrator::differential_algebraic>();
}

} // namespace
