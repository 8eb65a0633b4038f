#include <kanexpr/kanexpr.hpp>

int main() {}
