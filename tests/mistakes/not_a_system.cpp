// expect: Bob is not a system; derive it from kane_system<...>
#include "pendulum.hpp"

int main() { use<Bob>(); }
