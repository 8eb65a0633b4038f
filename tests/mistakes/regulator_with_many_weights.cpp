#include <kanexpr/control.hpp>

// expect: a diagonal of weights must have one entry for each state, or each input
const auto regulator = kanexpr::lqr(Eigen::Matrix2d(), Eigen::Vector2d(), {1, 2, 3}, {1});

int main() {}
