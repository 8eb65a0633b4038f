#include <kanexpr/ensembles/distribution.ipp>
#include <kanexpr/ensembles/runs.ipp>
