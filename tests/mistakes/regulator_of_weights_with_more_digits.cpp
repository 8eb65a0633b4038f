#include <kanexpr/control.hpp>

// expect: the weights have more digits than the numbers of A and B
const auto regulator = kanexpr::lqr(Eigen::Matrix2f(), Eigen::Vector2f(), Eigen::Vector2d(), {1});

int main() {}
