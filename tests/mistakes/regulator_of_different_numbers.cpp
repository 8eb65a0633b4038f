#include <kanexpr/control.hpp>

// expect: A and B have different scalar types
const auto regulator = kanexpr::lqr(Eigen::Matrix2d(), Eigen::Vector2f(), {1, 2}, {1});

int main() {}
