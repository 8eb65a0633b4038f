// expect: input T is listed, but nothing in the system uses it; if this is intended, write used_elsewhere<T>
#include "pendulum.hpp"

constexpr prescribed<"r"> r; // listed with its rates, of which one is used
struct Pushed : bound_pendulum<loads<force<S, dot(r) * N::x>>, inputs<r, dot(r), dot(dot(r)), T>> {};

int main() { use<Pushed>(); }
