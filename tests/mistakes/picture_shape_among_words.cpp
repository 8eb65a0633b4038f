// expect: sphere<...> stands among the words of the picture; write show<...> around it
#include "picture.hpp"

int main() { return draw<up<N::y>, sphere<P, l>>(); }
