// The headers of double_pendulum_symbolic.cpp.
#include <models/double_pendulum.hpp>

#include <kanexpr/symbolic.hpp>

#include <iostream>
