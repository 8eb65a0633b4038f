#include <kanexpr/control.hpp>

// expect: a diagonal of weights has a number for each state, or each input
const auto regulator = kanexpr::lqr(Eigen::Matrix2d(), Eigen::Vector2d(), {1, 2, 3}, {1});

int main() {}
