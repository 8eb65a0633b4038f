#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/independent_columns.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/base_parameters.hpp>

#include <Eigen/Core>
#include <cstdio>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::runtime {

/// The regressor of a system at random states that satisfy its constraints.
class random_regressors {
public:
  random_regressors(model& m, std::span<const double> p, std::uint64_t seed)
      : m_(m), p_(Eigen::Map<const Eigen::VectorXd>(p.data(), static_cast<Eigen::Index>(p.size()))),
        source_(seed), y_(m.function(m.get(mechanics::quantity::regressor))),
        dependency_(m.function(m.get(mechanics::quantity::dependency))),
        bias_(m.function(m.get(mechanics::quantity::acceleration_bias))) {}

  /// Returns stacked regressors with several times as many rows as columns; there are no rows if no states
  /// were found.
  Eigen::MatrixXd stacked(Eigen::Index columns) {
    const Eigen::Index rows = m_.mechanism().speeds.size() - m_.equations().speeds().dependent.size();
    const Eigen::Index states = rows == 0 ? 0 : 3 * columns / rows + 3;
    Eigen::MatrixXd all(rows * states, columns);
    Eigen::Index found = 0;
    for (Eigen::Index tried = 0; found < states && tried < 20 * states; ++tried)
      if (draw_state()) all.middleRows(rows * found++, rows) = y_(t_, x_, p_, r_, a_);
    return found < states ? Eigen::MatrixXd(0, columns) : all;
  }

  /// The reason why the last state was rejected.
  const base::sentence& cause() const { return cause_; }

private:
  Eigen::VectorXd numbers(int count, double reach) {
    std::uniform_real_distribution<double> unit(-reach, reach);
    return Eigen::VectorXd::NullaryExpr(count, [&] { return unit(source_); });
  }

  bool draw_state() {
    const mechanics::mechanism& moving = m_.mechanism();
    const mechanics::partition& speeds = m_.equations().speeds();
    t_ = numbers(1, 1)(0);
    x_.resize(moving.coordinates.size() + moving.speeds.size());
    x_ << numbers(moving.coordinates.size(), 3), numbers(moving.speeds.size(), 2);
    r_ = numbers(moving.inputs.size(), 1);
    a_ = numbers(moving.speeds.size(), 4);
    if (const assembly placed = kanexpr::assemble(m_, x_, p_, r_, t_); !placed) {
      cause_ = placed.failure;
      return false;
    }
    if (!speeds.dependent.empty()) {
      Eigen::VectorXd free(speeds.independent.size());
      for (int i = 0; i < speeds.independent.size(); ++i) free(i) = a_(speeds.independent[i]);
      const Eigen::VectorXd bound = dependency_(t_, x_, p_, r_) * free + bias_(t_, x_, p_, r_);
      for (int i = 0; i < speeds.dependent.size(); ++i) a_(speeds.dependent[i]) = bound(i);
    }
    const bool is_finite = numeric::all_finite(y_(t_, x_, p_, r_, a_));
    for (const auto* each : {&dependency_, &bias_, &y_})
      if (!each->status()) cause_ = base::sentence({each->status().view()});
    return is_finite && y_.status() && (speeds.dependent.empty() || (dependency_.status() && bias_.status()));
  }

  model& m_;
  Eigen::VectorXd p_;
  std::mt19937_64 source_;
  interpreted<double> y_, dependency_, bias_;
  base::sentence cause_{};
  double t_ = 0;
  Eigen::VectorXd x_{}, r_{}, a_{};
};

/// Returns, for example, "izz of A + 0.25*m of B - m*x of B".
inline std::string name_of_combination(const Eigen::MatrixXd& k, Eigen::Index row, Eigen::Index own,
                                       const std::vector<std::string>& names) {
  std::string text = names[static_cast<std::size_t>(own)];
  for (Eigen::Index j = 0; j < k.cols(); ++j) {
    const double share = k(row, j);
    if (j == own || std::abs(share) <= 0) continue;
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", std::abs(share));
    text.append(share < 0 ? " - " : " + ");
    if (std::string_view(digits) != "1") text.append(digits).append("*");
    text.append(names[static_cast<std::size_t>(j)]);
  }
  return text;
}

KANEXPR_ENGINE found_base_parameters find_base_parameters(model& m, std::span<const double> p,
                                                          const base_parameter_options& options) {
  found_base_parameters found;
  const auto refuse = [&](const base::sentence& because) {
    found.failure = because;
    return found;
  };
  const symbolic::matrix y = m.get(mechanics::quantity::regressor);
  if (!m.mistake().empty()) return refuse(base::sentence({m.mistake()}));
  if (!(numeric::is_finite(options.tolerance) && options.tolerance > 0 && options.tolerance < 1))
    return refuse(numeric::with_number("the tolerance of base parameters must be between 0 and 1, got ",
                                       options.tolerance));
  if (static_cast<int>(p.size()) != m.mechanism().parameters.size())
    return refuse(
        base::sentence({"base parameters: got ", base::counted(static_cast<int>(p.size())).view(),
                        " parameters, expected ", base::counted(m.mechanism().parameters.size()).view()}));
  for (int i = 0; i < m.mechanism().parameters.size(); ++i)
    if (!numeric::is_finite(p[static_cast<std::size_t>(i)]))
      return refuse(
          base::sentence({"parameter ", m.graph().symbol_at(m.mechanism().parameters[i].node()).called.view(),
                          " is not finite"}));
  random_regressors states(m, p, options.seed);
  const Eigen::MatrixXd all = states.stacked(y.columns);
  if (all.rows() == 0)
    return refuse(base::sentence(
        {"no states were found at which base parameters can be computed: ", states.cause().view()}));
  const numeric::independent_columns chosen = numeric::independent_columns_of(all, options.tolerance);
  constexpr double apart = 100;
  if (chosen.shortest_kept < apart * options.tolerance || chosen.longest_left * apart > options.tolerance)
    return refuse(numeric::with_number(
        "dependent and independent inertial parameters cannot be separated with a tolerance of ",
        options.tolerance));
  const std::vector<std::string> names = m.names_of_inertial_parameters();
  const mechanics::unit_table units = m.units();
  Eigen::Index row = 0;
  for (const Eigen::Index column : chosen.kept) {
    found.columns.push_back(static_cast<int>(column));
    if (units.is_stated) found.units.push_back(units.inertial_parameter(static_cast<int>(column)));
    for (Eigen::Index j = 0; j < y.columns; ++j) found.combination.push_back(chosen.combination(row, j));
    found.names.push_back(name_of_combination(chosen.combination, row++, column, names));
  }
  return found;
}

} // namespace kanexpr::runtime
