// expect: the picture contains acos of a number for which it is undefined
#include "picture.hpp"

int main() { return draw<up<N::y>, show<sphere<P, l * acos(rational<2, 1>)>>>(); }
