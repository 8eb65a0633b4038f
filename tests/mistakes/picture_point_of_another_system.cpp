// expect: frame M, which Z uses, is not connected to the inertial frame N
#include "picture.hpp"

struct M : inertial_frame<M> {};
struct Z : origin<Z, M> {};

int main() { return draw<up<N::y>, show<sphere<Z, 0.1>>>(); }
