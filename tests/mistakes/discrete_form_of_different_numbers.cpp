#include <kanexpr/control.hpp>

// expect: the numbers of A and B are of different types
const auto form = kanexpr::discretize(Eigen::Matrix2f(), Eigen::Vector2d(), 0.1f);

int main() {}
