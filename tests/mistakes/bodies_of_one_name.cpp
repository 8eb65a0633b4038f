// expect: two bodies are called Bob
#include "pendulum.hpp"

namespace other {
struct Bob : particle<Bob, P, m> {};
} // namespace other

struct System : pendulum_with<Bob, other::Bob> {};

int main() { use<System>(); }
