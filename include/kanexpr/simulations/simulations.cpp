#include <kanexpr/simulations/constraints/constraint_manifold.hpp>
#include <kanexpr/simulations/integration.hpp>
#include <kanexpr/simulations/progress.ipp>
#include <kanexpr/simulations/tables/csv.ipp>
#include <kanexpr/simulations/trim/trim_search.hpp>

namespace kanexpr::simulations {

template std::unique_ptr<manifold> manifold_of(const system_interface&);

template simulation_end run<integrator::adams>(system_interface&, double*, const time_span&, const settings&);
template simulation_end run<integrator::bdf>(system_interface&, double*, const time_span&, const settings&);
template simulation_end run<integrator::explicit_runge_kutta>(system_interface&, double*, const time_span&,
                                                              const settings&);
template simulation_end run<integrator::implicit_runge_kutta>(system_interface&, double*, const time_span&,
                                                              const settings&);
template simulation_end run<integrator::differential_algebraic>(system_interface&, double*, const time_span&,
                                                                const settings&);

} // namespace kanexpr::simulations
