// No include guard: every header with one-letter member names, as in ẋ = A x + B r, or with the unit pascal
// includes this file to suspend macros with the same names. letters_back.hpp, included at the end of that
// header, restores them.
#pragma push_macro("A")
#undef A
#pragma push_macro("B")
#undef B
#pragma push_macro("C")
#undef C
#pragma push_macro("D")
#undef D
#pragma push_macro("K")
#undef K
#pragma push_macro("M")
#undef M
#pragma push_macro("P")
#undef P
#pragma push_macro("W")
#undef W
#pragma push_macro("X")
#undef X
#pragma push_macro("Y")
#undef Y
#pragma push_macro("Z")
#undef Z
#pragma push_macro("pascal")
#undef pascal
