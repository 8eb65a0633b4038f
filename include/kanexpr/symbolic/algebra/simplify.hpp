#pragma once

#include <kanexpr/symbolic/algebra/cancel.hpp>
#include <kanexpr/symbolic/algebra/forms.hpp>
#include <kanexpr/symbolic/algebra/trigonometric_form.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>
#include <kanexpr/symbolic/linear/expand_solves.hpp>

namespace kanexpr::symbolic {

namespace detail {

inline int operations(expression e) {
  const cost c = cost_of(e.owner(), {e.node()});
  return c.multiplications + c.additions + c.divisions + 4 * (c.trigonometric + c.other);
}

} // namespace detail

KANEXPR_ENGINE expression simplify(expression e, std::size_t most_terms) {
  graph& g = e.owner();
  const expression written_out(g, expand_solves(g, {e.node()})[0]);
  expression best = written_out;
  int least = detail::operations(best);
  for (const expression form :
       {expression(cancel(written_out, most_terms)),
        expression(cancel(trigonometric_normal_form(written_out, most_terms), most_terms))})
    if (const int taken = detail::operations(form); taken < least) best = form, least = taken;
  return best;
}

KANEXPR_ENGINE matrix simplify(matrix m, std::size_t most_terms) {
  for (expression& e : m.entries) e = simplify(e, most_terms);
  return m;
}

} // namespace kanexpr::symbolic
