#include <kanexpr/ensemble/hdf5/engine/study_file.hpp>
