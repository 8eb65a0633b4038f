#pragma once

#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/simulations/compiled_simulations.hpp>

#include <Eigen/Core>

#include <complex>
#include <string>
#include <string_view>
#include <vector>

/// The part of the search for operating points that does not depend on the system.
namespace kanexpr::simulations {

/// The requirements on an operating point.
struct requirements {
  const std::vector<symbol_name>&held, &freed, &changing;
  const std::vector<named_value>& rates;
  double t = 0;
  double tolerance = 0; ///< permitted residual of each equation, relative to its magnitude
  int most_iterations = 0;
};

/// The functions of a system that the search for an operating point needs. They evaluate [constraints; ẋ] at
/// time t and [x; p; r]. They are given either as tables or as a compiled function in a library; the function
/// returns a message that names the singular linear system, or an empty string if there is none.
struct system_functions {
  using library = std::string_view (*)(double t, const std::complex<double>* at, std::complex<double>* all);

  const derivation::survey& known;
  const describe::system_record& record;
  std::string_view name;
  const compiled::code_table *constraints, *rates; ///< null if there are none, or if a library contains them
  library compiled;
};

/// The name of an equation, such as "the rate of speed u2", and its residual.
struct residual {
  std::string name;
  double value;
};

/// The result of a search.
struct search_result {
  Eigen::VectorXd values{}; ///< [x; p; r]
  int iterations = 0;
  int freedom = 0;
  std::string failure{};
  std::vector<residual> residuals{}; ///< residuals of all equations
};

/// Searches for an operating point from a guess of [x; p; r].
KANEXPR_SIMULATIONS search_result find(const system_functions& system, const requirements& asked,
                                       const Eigen::VectorXd& guess);

} // namespace kanexpr::simulations
