// A coin rolls on a table and wobbles.
#include <kanexpr/simulate.hpp>
#include <parts/page.hpp>
#include <pictures/rolling_disc.hpp>

int main(int count, char** words) {
  using namespace rolling_disc;
  gallery::page page(
      count, words,
      {.title = "Rolling disc",
       .kind = "Rolling",
       .see = "The disc leans and turns to the side to which it leans, so it does not fall over. It rolls "
              "without slipping: the point of contact has no velocity, and no energy is lost.",
       .source = "Kane & Levinson, Dynamics: Theory and Applications (1985), section 3.8"});
  const auto run = simulate<System>({{q1, 0}, {q2, 0.35}, {q3, 0}, {u1, 0}, {u2, 6}, {u3, 1.2}},
                                    {{m, 2}, {r, 0.3}, {g, 9.81}}, {0, 8},
                                    {.relative_tolerance = 1e-10, .output_every = 0.02});
  std::vector<double> energy = run.trajectory.along(equations_of_motion<System>::kinetic_energy);
  for (std::size_t i = 0; i < energy.size(); ++i)
    energy[i] += 2 * 9.81 * 0.3 * std::cos(run.trajectory[i].x[q2]);
  page.expect_constant("the total energy", energy, energy.front(), 1e-7);
  double most = 0;
  for (const double lean : run.trajectory[q2]) most = std::max(most, std::abs(lean));
  page.expect(most < 1, "the disc never leans by more than a radian");
  return page.show<rolling_disc::picture>(run);
}
