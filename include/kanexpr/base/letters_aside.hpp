// Without a guard: it stands in each header in which members are called by one letter, as in ẋ = A x + B r,
// and takes macros of such names aside. Behind the last line of that header letters_back.hpp brings them
// back.
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
