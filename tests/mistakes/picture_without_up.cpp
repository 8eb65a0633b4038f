// expect: the picture does not specify the up direction; add up<vector>
#include "picture.hpp"

int main() { return draw<show<sphere<P, 0.1>>>(); }
