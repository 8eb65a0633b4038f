#include <kanexpr/runtime/model.ipp>
#include <kanexpr/runtime/staged_derivation.ipp>
