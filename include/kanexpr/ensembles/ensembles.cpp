#include <kanexpr/ensembles/csv_file.ipp>
#include <kanexpr/ensembles/distribution.ipp>
#include <kanexpr/ensembles/run_on_threads.ipp>
#include <kanexpr/ensembles/runs.ipp>
