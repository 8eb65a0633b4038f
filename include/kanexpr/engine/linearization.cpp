#include <kanexpr/runtime/linearization.ipp>
#include <kanexpr/runtime/linearization_point.ipp>
