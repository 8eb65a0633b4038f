#include "model.hpp"

template struct kanexpr::compiled::instance<double, exchanged::motion>;
