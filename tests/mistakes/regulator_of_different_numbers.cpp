#include <kanexpr/control.hpp>

// expect: the numbers of A and B are of different types
const auto regulator = kanexpr::lqr(Eigen::Matrix2d(), Eigen::Vector2f(), {1, 2}, {1});

int main() {}
