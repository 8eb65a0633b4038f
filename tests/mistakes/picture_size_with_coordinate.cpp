// expect: the radius of the sphere at P contains the coordinate q; it may depend only on parameters
#include "picture.hpp"

int main() { return draw<up<N::y>, show<sphere<P, l * q>>>(); }
