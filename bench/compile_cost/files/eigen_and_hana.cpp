// What every other file is a multiple of.
#include <Eigen/Dense>
#include <boost/hana.hpp>
