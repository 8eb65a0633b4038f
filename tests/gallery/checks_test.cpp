// builds: clang++
#include "gallery/parts/checks.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

struct energy {
  std::vector<double> kinetic, total;
};
struct path {
  energy given{};
  std::vector<double> residuals{};
  const energy& energies() const { return given; }
  const std::vector<double>& constraint_residuals() const { return residuals; }
};

TEST(gallery_checks, list_what_holds) {
  gallery::checks c;
  c.expect(true, "the stone reverses its spin");
  c.expect_energy(path{.given = {{0, 2, 1}, {3, 3.0002, 3}}}, 1e-3);
  c.expect_constraints(path{.residuals = {1e-12, 3.14e-12}}, 1e-9);
  EXPECT_TRUE(c.holds()) << c.cause();
  EXPECT_EQ(c.proofs(), (std::vector<std::string>{"the stone reverses its spin",
                                                  "the total energy stays constant, to within 1.0 × 10⁻⁴",
                                                  "all constraints hold, to within 3.1 × 10⁻¹²"}));
}

TEST(gallery_checks, stop_a_page_with_a_sentence) {
  gallery::checks c;
  c.expect_energy(path{.given = {{0, 2}, {3, 3.5}}}, 1e-3);
  c.expect(false, "the second sentence counts");
  EXPECT_FALSE(c.holds());
  EXPECT_EQ(
      c.cause(),
      "the motion does not show that the total energy stays constant to within 0.001; the error is 0.25");
}

TEST(gallery_checks, refuse_a_motion_without_samples_or_numbers) {
  gallery::checks empty;
  empty.expect_energy(path{}, 1);
  EXPECT_EQ(empty.cause(), "the motion has no samples");
  gallery::checks unknown;
  unknown.expect_constant("the spin", {1, std::numeric_limits<double>::quiet_NaN()}, 1, 1e-3);
  EXPECT_FALSE(unknown.holds());
}

} // namespace
