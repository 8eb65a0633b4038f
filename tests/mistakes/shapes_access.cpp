// Expressions in place of symbols when a vector of values is accessed.
#include "shapes.hpp"

struct System : loaded<weight, torque<A, T * N::z>> {};

// expect: the expression is not an entry of the state vector of System
auto product(state<System>& x) { return x[q * q]; }

// expect: the expression is not an entry of the parameter vector of System
auto axis(const parameter_values<System>& p) { return p[N::x]; }

// expect: the expression is not an entry of the input vector of System
auto negative(input_values<System>& r) { return r[-T]; }
