// expect: two points are called Tip
#include "pendulum.hpp"

namespace left {
struct Tip : offset<Tip, O, l * A::x> {};
} // namespace left
namespace right {
struct Tip : offset<Tip, left::Tip, l * A::x> {};
} // namespace right
struct Ball : particle<Ball, right::Tip, m> {};

struct System : pendulum_with<Ball> {};

int main() { use<System>(); }
