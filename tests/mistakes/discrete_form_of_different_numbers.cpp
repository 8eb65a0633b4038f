#include <kanexpr/control.hpp>

// expect: A and B have different scalar types
const auto form = kanexpr::discretize(Eigen::Matrix2f(), Eigen::Vector2d(), 0.1f);

int main() {}
