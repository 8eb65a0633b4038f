// expect: the file of the mesh at P, arm.step, is none of the kinds .stl, .dae and .obj
#include "picture.hpp"

int main() { return draw<up<N::y>, show<mesh<A, P, "arm.step">>>(); }
