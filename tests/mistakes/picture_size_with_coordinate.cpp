// expect: the radius of the sphere at P holds the coordinate q; it may hold parameters only
#include "picture.hpp"

int main() { return draw<up<N::y>, show<sphere<P, l * q>>>(); }
