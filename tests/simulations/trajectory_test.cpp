// builds: clang++ sanitize
// Trajectories: states between the samples, expressions along them, columns by name.
#include "simulations/falling_ball.hpp"

#include <kanexpr/simulate.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

namespace {

using namespace kanexpr;

namespace swinging {

using namespace simple_pendulum;

template <integrator by>
simulation<System> run_with(simulation_options<System> options) {
  options.inputs = {{T, 0.3}};
  return simulate<System, by>({{q, 2.0}, {u, 0.5}}, {{m, 2}, {l, 0.5}, {g, 9.81}, {c, 0.1}}, {0, 5}, options);
}

} // namespace swinging

// The polynomials of the integrator preserve its accuracy between the samples.
template <integrator by>
void knows_the_states_between_samples(double error) {
  using namespace swinging;
  const auto sparse = run_with<by>({.output_every = 0.5, .dense = true});
  const auto exact = run_with<integrator::explicit_runge_kutta>(
      {.relative_tolerance = 1e-12, .absolute_tolerance = 1e-13, .output_every = 0.01});
  ASSERT_TRUE(sparse) << sparse.cause();
  ASSERT_EQ(sparse.trajectory.size(), 11u);
  for (const auto& s : exact.trajectory) {
    const auto found = sparse.trajectory.at(s.t);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->t, s.t);
    EXPECT_LT((found->x - s.x).cwiseAbs().maxCoeff(), error) << s.t;
  }
  EXPECT_FALSE(sparse.trajectory.at(-0.1));
  EXPECT_FALSE(sparse.trajectory.at(5.1));
  EXPECT_FALSE(sparse.trajectory.at(std::nan("")));
  EXPECT_EQ(sparse.trajectory.at(5)->x, sparse.state);
}

TEST(trajectory, is_dense_on_request) {
  knows_the_states_between_samples<integrator::adams>(2e-6);
  knows_the_states_between_samples<integrator::bdf>(2e-5);
  knows_the_states_between_samples<integrator::explicit_runge_kutta>(2e-6);
  knows_the_states_between_samples<integrator::implicit_runge_kutta>(2e-6);
  knows_the_states_between_samples<integrator::differential_algebraic>(2e-5);
}

TEST(trajectory, has_cubics_between_samples_otherwise) {
  using namespace swinging;
  double errors[2];
  for (const int fine : {0, 1}) {
    const auto run = run_with<integrator::adams>(
        {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-12, .output_every = fine == 1 ? 0.01 : 0.02});
    const auto exact = run_with<integrator::adams>(
        {.relative_tolerance = 1e-11, .absolute_tolerance = 1e-12, .output_every = 0.0025});
    errors[fine] = 0;
    for (const auto& s : exact.trajectory)
      errors[fine] = std::max(errors[fine], (run.trajectory.at(s.t)->x - s.x).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(errors[1], 1e-6);
  EXPECT_NEAR(errors[0] / errors[1], 16, 3); // of fourth order
}

// A bounce is not smoothed: before it the ball falls, after it the ball rises.
TEST(trajectory, is_dense_on_both_sides_of_an_event) {
  using namespace falling_ball;
  const auto run = simulate<System>(
      {{h, 1}, {v, 0}}, {{m, 1}, {g, 10}}, {0, 1},
      {.output_times = {0, 1},
       .dense = true,
       .events = {when<System, falling_ball::h>("contact", crossing::falling,
                                                [](moment<System>& now) { now.x[v] = -now.x[v]; })}});
  ASSERT_TRUE(run) << run.cause();
  ASSERT_EQ(run.events.size(), 1u);
  const double bounce = std::sqrt(0.2);
  for (const double t : {0.01, 0.3, bounce - 1e-6, bounce + 1e-6, 0.7, 0.99}) {
    const double since = t < bounce ? t : 2 * bounce - t;
    EXPECT_NEAR(run.trajectory.at(t)->x[h], 1 - 5 * since * since, 1e-7) << t;
    EXPECT_NEAR(run.trajectory.at(t)->x[v], (t < bounce ? -10 : 10) * since, 1e-6) << t;
  }
}

TEST(trajectory, evaluates_expressions_of_the_model) {
  using namespace swinging;
  using eom = equations_of_motion<System>;
  const auto run = run_with<integrator::adams>({.output_every = 0.1});
  const auto& path = run.trajectory;
  const std::vector<double> kinetic = path.along(eom::kinetic_energy);
  const auto velocities = path.along<velocity_of<P>>();
  const auto [k, v, total] = path.energies();
  ASSERT_EQ(kinetic.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double angle = path[i].x[q], rate = path[i].x[u];
    EXPECT_NEAR(kinetic[i], 0.25 * rate * rate, 1e-14);
    EXPECT_EQ(k[i], kinetic[i]);
    EXPECT_NEAR(v[i] - v[0], -9.81 * (std::cos(angle) - std::cos(path[0].x[q])), 1e-12);
    EXPECT_NEAR(total[i], k[i] + v[i], 1e-15 + 1e-15 * std::abs(v[i]));
    EXPECT_LT((velocities[i] - 0.5 * rate * Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0)).norm(),
              1e-14);
  }
  EXPECT_THAT(path.constraint_residuals(), testing::Each(0.0));
}

TEST(trajectory, is_a_table_with_names) {
  using namespace swinging;
  const auto run = run_with<integrator::adams>({.output_every = 0.1});
  table columns = run.trajectory.table();
  ASSERT_TRUE(columns.add("energy", run.trajectory.energies().total));
  EXPECT_THAT(columns.names(), testing::ElementsAre("t", "q", "u", "T", "energy"));
  std::stringstream file;
  ASSERT_TRUE(write_csv(columns, file));
  const auto read = read_csv(file);
  ASSERT_TRUE(read) << read.cause();
  EXPECT_THAT(read["q"], testing::ElementsAreArray(run.trajectory[simple_pendulum::q]));
  EXPECT_THAT(read["u"], testing::ElementsAreArray(run.trajectory[simple_pendulum::u]));
  EXPECT_THAT(read["T"], testing::Each(0.3));
  EXPECT_THAT(read["t"], testing::ElementsAreArray(run.trajectory.times()));
}

// A model that uses the usual names of the time for its symbols.
namespace named_as_time {

constexpr coordinate<"t"> t;
constexpr speed<"time"> time;
constexpr parameter<"time_"> time_;

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, t * N::x> {};
struct Hand : particle<Hand, P, time_> {};
struct System : kane_system<inertial<N>, coordinates<t>, speeds<time>, kinematics<dot(t) == time>,
                            bodies<Hand>, parameters<time_>> {};

} // namespace named_as_time

TEST(trajectory, is_a_table_with_every_column_for_any_names_in_the_model) {
  trajectory<named_as_time::System> path;
  path.add({5, {1, 2}, {}});
  const table columns = path.table();
  EXPECT_THAT(columns.names(), testing::ElementsAre("time__", "t", "time"));
  EXPECT_EQ(columns["time__"][0], 5);
  EXPECT_EQ(columns["t"][0], 1);
  EXPECT_EQ(columns["time"][0], 2);
}

} // namespace
