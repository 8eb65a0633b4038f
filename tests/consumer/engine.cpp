#include "pendulum.hpp"

#include <kanexpr/algebra.hpp>
#include <kanexpr/runtime/assemble.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <cmath>

// Uses every part that works at run time, compiled here or linked.
int main() {
  using namespace pendulum;
  auto model = kanexpr::derive<System>();
  auto udot = model.function(model.udot());
  const Eigen::Vector2d x(0.5, 0);
  bool is_good = std::abs(udot(x, Eigen::VectorXd::Constant(1, 2))(0) + 9.81 / 2 * std::sin(0.5)) < 1e-15;

  auto linear = model.linearize({{q, 0}, {u, 0}, {l, 9.81}});
  is_good = is_good && kanexpr::symbolic::print(linear.explicit_form().A) == "[0,  1]\n[-1, 0]";
  is_good = is_good && !kanexpr::symbolic::latex(kanexpr::symbolic::simplify(model.rhs())).empty();
  Eigen::VectorXd state = x;
  is_good = is_good && kanexpr::assemble(model, state, Eigen::VectorXd::Ones(1));

  kanexpr::runtime::builder b("N");
  const auto free = b.coordinate("q"), rate = b.speed("u");
  b.kinematic_equation(b.dot(free) - rate);
  const auto along_x = b.along(b.inertial_frame(), free, b.number(0.0), b.number(0.0));
  b.particle("Bob", b.offset("P", b.origin("O"), along_x), b.number(2));
  is_good = is_good && kanexpr::symbolic::print(kanexpr::derive(b).mass_matrix()) == "[2]";
  return is_good ? 0 : 1;
}
