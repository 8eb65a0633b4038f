#pragma once

#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/simulate/compiled_simulations.hpp>

#include <Eigen/Core>

#include <complex>
#include <string>
#include <vector>

/// The search for operating points, as far as it does not depend on the system.
namespace kanexpr::trim {

/// What is asked of an operating point.
struct wishes {
  const std::vector<symbol_name>&held, &freed, &changing;
  const std::vector<named_value>& rates;
  double t = 0;
  double tolerance = 0; ///< of every equation, beside what its unknowns make of it
  int most_iterations = 0;
};

/// A system as the search sees it, with [constraints; ẋ] at the time t and [x; p; r]: as tables, or in a
/// library that has it compiled. This says what could not be solved there, as a sentence.
struct subject {
  using library = std::string_view (*)(double t, const std::complex<double>* at, std::complex<double>* all);

  const deriving::survey& known;
  const describe::system_record& told;
  std::string_view name;
  const compiled::code_table *constraints, *rates; ///< null: there are none, or a library has them
  library compiled;
};

/// An equation with its name, "the rate of speed u2", and what it leaves.
struct residual {
  std::string name;
  double value;
};

/// What a search found.
struct finding {
  Eigen::VectorXd values{}; ///< [x; p; r]
  Eigen::VectorXd left{};   ///< of each equation
  int iterations = 0;
  int freedom = 0;
  std::string failure{};
  std::vector<residual> residuals{};
};

/// Searches from a guess of [x; p; r].
KANEXPR_SIMULATIONS finding find(const subject& system, const wishes& asked, const Eigen::VectorXd& guess);

} // namespace kanexpr::trim
