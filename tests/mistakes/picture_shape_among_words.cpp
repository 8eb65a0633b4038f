// expect: sphere<...> is a shape, not an element of the picture; wrap it in show<...>
#include "picture.hpp"

int main() { return draw<up<N::y>, sphere<P, l>>(); }
