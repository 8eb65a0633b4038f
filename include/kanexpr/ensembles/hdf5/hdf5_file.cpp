#include <kanexpr/ensembles/hdf5/study_file.ipp>
