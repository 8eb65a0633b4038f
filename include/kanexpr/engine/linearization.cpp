#include <kanexpr/runtime/assemble.ipp>
#include <kanexpr/runtime/base_parameters.ipp>
#include <kanexpr/runtime/linearization.ipp>
#include <kanexpr/runtime/linearization_point.ipp>
