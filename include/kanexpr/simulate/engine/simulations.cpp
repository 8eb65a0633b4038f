#include <kanexpr/simulate/constraints/constraint_manifold.hpp>
#include <kanexpr/simulate/integration.hpp>
#include <kanexpr/simulate/progress.ipp>
#include <kanexpr/simulate/tables/csv.ipp>
#include <kanexpr/simulate/tables/table.ipp>
#include <kanexpr/simulate/trajectory/dense_output.ipp>
#include <kanexpr/simulate/trim/trim_search.hpp>

namespace kanexpr::simulated {

template std::unique_ptr<manifold> manifold_of(const system_interface&);

template run_outcome run<integrator::adams>(system_interface&, const double*, const time_span&,
                                            const settings&);
template run_outcome run<integrator::bdf>(system_interface&, const double*, const time_span&,
                                          const settings&);
template run_outcome run<integrator::explicit_runge_kutta>(system_interface&, const double*, const time_span&,
                                                           const settings&);
template run_outcome run<integrator::implicit_runge_kutta>(system_interface&, const double*, const time_span&,
                                                           const settings&);
template run_outcome run<integrator::differential_algebraic>(system_interface&, const double*,
                                                             const time_span&, const settings&);

} // namespace kanexpr::simulated
