#include <kanexpr/runtime/builder.ipp>
#include <kanexpr/runtime/builder_beam.ipp>
#include <kanexpr/runtime/builder_constraints.ipp>
#include <kanexpr/runtime/builder_flexible_body.ipp>
#include <kanexpr/runtime/builder_flexible_data.ipp>
#include <kanexpr/runtime/builder_loads.ipp>
#include <kanexpr/runtime/model.ipp>
#include <kanexpr/runtime/staged_derivation.ipp>
