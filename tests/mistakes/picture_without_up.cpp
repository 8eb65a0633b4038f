// expect: the picture does not say which way is up; write up<vector>
#include "picture.hpp"

int main() { return draw<show<sphere<P, 0.1>>>(); }
