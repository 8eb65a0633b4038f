#include <pictures/bicycle.hpp>

#include <kanexpr/algebra.hpp>
#include <kanexpr/operating_point.hpp>
#include <kanexpr/simulate.hpp>
#include <kanexpr/symbolic.hpp>

#include <iostream>

/// Everything that docs/tour.md does with the bicycle, in one file.
int main() {
  using namespace bicycle;
  using namespace kanexpr;

  const auto run =
      simulate<BoundSystem>({{q1, 0}, {q2, 0}, {q5, 0}, {u2, 0.2}, {u3, 4.6 / 0.3}, {u5, 0}}, {}, {0, 10},
                            {.output_every = 0.02, .events = {when<BoundSystem, q2>("upright")}});
  if (!run) std::cerr << run.cause() << '\n';
  std::cout.precision(17);
  std::cout << run.events[0].t << ' ' << run.trajectory[q2].back() << ' '
            << run.trajectory.along<velocity_of<Frame_mc>>().back().transpose() << ' '
            << run.trajectory.energies().total.back() << '\n';
  if (const auto written = write_page<bicycle::picture>("bicycle.html", run.trajectory); !written)
    std::cerr << written.cause() << '\n';

  const operating_point<BoundSystem> turn({{q2, 0.2}, {u3, 20}, {u6, 17}}, {},
                                          {.held = {q2}, .changing = {q1}});
  if (!turn) std::cerr << turn.cause() << '\n';
  std::cout << turn.x.transpose() << '\n';

  const auto [A, B] = linearization<BoundSystem>::explicit_form(turn.x, turn.p, turn.r);
  std::cout << A << '\n' << B << '\n';

  auto model = derive<BoundSystem>();
  std::cout << symbolic::print(model.mass_matrix()).size() << '\n';
  auto linear = model.linearize(turn);
  std::cout << symbolic::print(linear.explicit_form().A) << '\n';
  for (const std::string& failure : linear.failures()) std::cerr << failure << '\n';
}
