#include <kanexpr/ensembles/csv_file.ipp>
