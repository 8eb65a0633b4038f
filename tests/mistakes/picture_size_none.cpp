// expect: the picture holds acos of a number for which it has no value
#include "picture.hpp"

int main() { return draw<up<N::y>, show<sphere<P, l * acos(rational<2, 1>)>>>(); }
