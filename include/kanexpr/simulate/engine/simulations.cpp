#include <kanexpr/simulate/constraints/constraint_manifold.hpp>
#include <kanexpr/simulate/integration.hpp>
#include <kanexpr/simulate/progress.ipp>
#include <kanexpr/simulate/tables/csv.ipp>
#include <kanexpr/simulate/tables/table.ipp>
#include <kanexpr/simulate/trajectory/dense_output.ipp>
#include <kanexpr/simulate/trim/search.hpp>

namespace kanexpr::simulated {

template std::unique_ptr<manifold> manifold_of(const system&);

template ending run<integrator::adams>(system&, const double*, const time_span&, const settings&);
template ending run<integrator::bdf>(system&, const double*, const time_span&, const settings&);
template ending run<integrator::explicit_runge_kutta>(system&, const double*, const time_span&,
                                                      const settings&);
template ending run<integrator::implicit_runge_kutta>(system&, const double*, const time_span&,
                                                      const settings&);
template ending run<integrator::differential_algebraic>(system&, const double*, const time_span&,
                                                        const settings&);

} // namespace kanexpr::simulated
