// Identifies the friction of a pendulum from noisy measurements of its angle while it swings down. The
// Levenberg-Marquardt method minimizes the sum of squares, with derivatives that are integrated together with
// the motion. A thousand records show how far the estimates spread, compared with the Cramér-Rao bound, which
// limits the variance of every unbiased estimate.
#include <kanexpr/ensemble.hpp>
#include <kanexpr/simulations/progress.hpp>
#include <kanexpr/simulations/tables/csv.hpp>
#include <models/simple_pendulum.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace {

using namespace kanexpr;
using namespace kanexpr::units::si;
using namespace simple_pendulum;

// In addition to viscous friction, dry (Coulomb) friction, which is smoothed near zero speed.
constexpr parameter<"k", newton * meter> k;
constexpr auto slow = constant<0.2, radian / second>;
struct Rubbing
    : extended<simple_pendulum::System, parameters<k>, loads<torque<A, -k * tanh(u / slow) * N::z>>> {};

constexpr double viscous = 0.02, dry = 0.05;                             // N m s, N m
constexpr double noise = 0.01, first_angle = 1, every = 0.02, last = 10; // rad, rad, s, s
constexpr int samples = 500, steps_between = 4;

parameter_values<Rubbing> rubbing(double c_is, double k_is) {
  return {{m, 0.5}, {l, 0.7}, {g, 9.81}, {c, c_is}, {k, k_is}};
}

using record = Eigen::Matrix<double, samples, 1>; // angles
using slopes = Eigen::Matrix<double, samples, 2>; // derivatives of the angles by c and k
using rates = Eigen::Matrix<double, 2, 3>;        // of the state, and their derivatives by c and k

// S' = (dx'/dx) S + dx'/dp is integrated together with x'.
rates rates_at(const rates& at, const parameter_values<Rubbing>& p) {
  const state<Rubbing> x = at.col(0);
  const input_values<Rubbing> r(0);
  const Eigen::Matrix2d by_state = std::get<0>(linearization<Rubbing>::jacobian(x, p, r));
  rates all;
  all.col(0) = equations_of_motion<Rubbing>::rhs(x, p, r);
  all.rightCols<2>() = by_state * at.rightCols<2>() + sensitivity<Rubbing, c, k>(x, p, r);
  return all;
}

struct swing {
  record angles;
  slopes by_friction;
};

swing swing_with(const Eigen::Vector2d& friction) {
  const parameter_values<Rubbing> p = rubbing(friction(0), friction(1));
  constexpr double h = every / steps_between;
  rates at = rates::Zero();
  at(0, 0) = first_angle;
  swing found;
  for (int i = 0; i < samples; ++i) {
    for (int step = 0; step < steps_between; ++step) {
      const rates a = rates_at(at, p), b = rates_at(at + h / 2 * a, p), d = rates_at(at + h / 2 * b, p),
                  e = rates_at(at + h * d, p);
      at += h / 6 * (a + 2 * b + 2 * d + e);
    }
    found.angles(i) = at(0, 0);
    found.by_friction.row(i) = at.row(0).tail<2>();
  }
  return found;
}

// The friction for which the pendulum swings most like the record; NaN if none is found.
Eigen::Vector2d friction_of(const record& measured) {
  Eigen::Vector2d friction(0.1, 0.01);
  swing now = swing_with(friction);
  double damping = 1e-3;
  for (int turn = 0; turn < 50; ++turn) {
    const record off = measured - now.angles;
    Eigen::Matrix2d normal = now.by_friction.transpose() * now.by_friction;
    normal.diagonal() *= 1 + damping;
    const Eigen::Vector2d change = normal.ldlt().solve(now.by_friction.transpose() * off);
    const swing next = swing_with(friction + change);
    if ((measured - next.angles).squaredNorm() > off.squaredNorm()) {
      damping *= 10;
      continue;
    }
    friction += change, now = next, damping /= 10;
    if (change.norm() < 1e-9 * friction.norm()) return friction;
  }
  return Eigen::Vector2d::Constant(NAN);
}

// No unbiased estimate has a smaller covariance.
Eigen::Matrix2d cramer_rao_bound() {
  const slopes S = swing_with({viscous, dry}).by_friction;
  return noise * noise * (S.transpose() * S).inverse();
}

record recorded(const run_values& given, const simulation<Rubbing>& run) {
  std::mt19937_64 random(static_cast<std::uint64_t>(given[factor{"seed"}]));
  std::normal_distribution<double> error(0, noise);
  record angles;
  for (int i = 0; i < samples; ++i)
    angles(i) = run.trajectory[static_cast<std::size_t>(i) + 1].x[q] + error(random);
  return angles;
}

study<Rubbing> records(std::size_t count) {
  const auto estimated = [](int place) {
    return [=](const run_values& given, const simulation<Rubbing>& run) {
      return friction_of(recorded(given, run))(place);
    };
  };
  return {.runs = random_runs(count, {{factor{"seed"}, uniform(0, 1e15)}}, 1951),
          .state = {{q, first_angle}, {u, 0}},
          .parameters = {{m, 0.5}, {l, 0.7}, {g, 9.81}, {c, viscous}, {k, dry}},
          .inputs = {{T, 0}},
          .span = {0, last},
          .simulation = {.relative_tolerance = 1e-10, .output_every = every},
          .keep = {result("c", estimated(0), "N m s"), result("k", estimated(1), "N m")}};
}

// Angles in the first record: the measured ones, and those computed with the identified friction.
table first_record(const ensemble_results& found) {
  const study<Rubbing> told = records(1);
  const auto run = simulate<Rubbing>(told.state, told.parameters, told.span,
                                     {.inputs = given_inputs<Rubbing>(told.inputs),
                                      .relative_tolerance = told.simulation.relative_tolerance,
                                      .output_every = every});
  const record measured = recorded(run_values(told.runs, 0), run);
  const swing fitted = swing_with({found.runs["c"][0], found.runs["k"][0]});
  std::vector<double> t, angles, smooth;
  for (int i = 0; i < samples; ++i)
    t.push_back(every * (i + 1)), angles.push_back(measured(i)), smooth.push_back(fitted.angles(i));
  table all;
  if (!all.add("t", t) || !all.add("measured", angles) || !all.add("fitted", smooth)) std::abort();
  return all;
}

} // namespace

// identified_friction [RECORDS [FILE]]: writes the estimates to FILE, the bound to FILE.bound, and one record
// to FILE.record.
int main(int count, char** words) {
  const std::size_t wanted = count > 1 ? std::strtoul(words[1], nullptr, 10) : 100;
  const auto found =
      ensemble<Rubbing>(records(wanted))
          .run({.reduce = {statistics_of("c"), statistics_of("k")}, .progress = progress_bar()});
  if (!found || found.failed > 0) {
    const std::string why = found ? found.failures[0].cause : found.cause();
    return std::fprintf(stderr, "%s\n", why.c_str()), 1;
  }
  const Eigen::Matrix2d bound = cramer_rao_bound();
  bool is_as_expected = true;
  const std::array truth{viscous, dry};
  for (int i = 0; i < 2; ++i) {
    const auto& all = found.statistics(i == 0 ? "c" : "k");
    const double least = std::sqrt(bound(i, i)), ratio = all.deviation() / least;
    const double bias = (all.mean() - truth[static_cast<std::size_t>(i)]) / all.error_of_mean();
    std::printf("%s of %g: estimates spread by %.3g, %.3f times the bound; their mean is %+.1f of its "
                "errors off\n",
                i == 0 ? "viscous friction" : "dry friction", truth[static_cast<std::size_t>(i)],
                all.deviation(), ratio, bias);
    const double luck = 5 / std::sqrt(2 * static_cast<double>(wanted));
    is_as_expected &= std::abs(ratio - 1) < luck && std::abs(bias) < 5;
  }

  if (count > 2) {
    const std::string file = words[2];
    table limit;
    const bool left = limit.add("c", {viscous}) && limit.add("k", {dry}) && limit.add("cc", {bound(0, 0)}) &&
                      limit.add("ck", {bound(0, 1)}) && limit.add("kk", {bound(1, 1)}) &&
                      write_csv(found.runs, file, {.with_units = false}) &&
                      write_csv(limit, file + ".bound") && write_csv(first_record(found), file + ".record");
    if (!left) return std::fprintf(stderr, "%s could not be written\n", words[2]), 1;
  }
  return is_as_expected ? 0 : 1;
}
