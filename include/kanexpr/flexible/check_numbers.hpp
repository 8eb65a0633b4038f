#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

namespace kanexpr::flexible {

/// Whether all numbers of a body are finite; otherwise, the report contains the mistake.
inline bool check_numbers(const mechanics::flexible_data& d, file_report& report) {
  bool finite = numeric::is_finite(d.mass);
  const auto check_all = [&](const base::sequence<double>& numbers) {
    for (const double each : numbers) finite = finite && numeric::is_finite(each);
  };
  for (const base::sequence<double>* each :
       {&d.first_moment.coefficients, &d.inertia.coefficients, &d.angular.coefficients, &d.modal_mass,
        &d.stiffness, &d.damping, &d.preload})
    check_all(*each);
  for (const mechanics::flexible_node& n : d.nodes) {
    check_all(n.position.coefficients);
    check_all(n.orientation);
    check_all(n.rotation);
    check_all(n.second_rotation);
  }
  for (const mechanics::elastic_term& t : d.elastic_terms)
    finite = finite && numeric::is_finite(t.coefficient);
  for (const mechanics::damping_term& t : d.damping_terms)
    finite = finite && numeric::is_finite(t.coefficient);
  return finite || report.fail("the integrals of the body overflow");
}

} // namespace kanexpr::flexible
