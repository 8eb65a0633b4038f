// The control: nothing is wrong here, so this must compile.
#include <kanexpr/kanexpr.hpp>

int main() {}
