#include <kanexpr/runtime/builder.ipp>
#include <kanexpr/runtime/builder_constraints.ipp>
#include <kanexpr/runtime/builder_loads.ipp>
