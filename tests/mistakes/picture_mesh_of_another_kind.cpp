// expect: the file of the mesh at P, arm.step, is not of the type .stl, .dae or .obj
#include "picture.hpp"

int main() { return draw<up<N::y>, show<mesh<A, P, "arm.step">>>(); }
