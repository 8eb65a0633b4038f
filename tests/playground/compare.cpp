// compare MODEL FOLDER: compares the files that the page wrote with those of this program, and the compiled
// types with the compiled C code at random states.
#include "crane.hpp"
#include "crane_c/crane.h"

#include "playground/session.hpp"
#include "playground/take_away/export_c.hpp"
#include "playground/take_away/export_fmu.hpp"
#include "playground/take_away/write_words.hpp"

#include <Eigen/Core>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace {

std::string contents_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int failures = 0;

void compare(const playground::files& expected, const std::string& folder) {
  for (const auto& each : expected.all)
    if (contents_of(folder + '/' + each.path) != each.text)
      std::printf("%s differs from the file of a native program\n", each.path.c_str()), ++failures;
}

void compare_mass_matrices() {
  using eom = kanexpr::equations_of_motion<crane::System>;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> any(0.3, 1.3);
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    eom::state x;
    eom::parameters p;
    eom::inputs r;
    for (auto* each : {x.data(), x.data() + 1, x.data() + 2, x.data() + 3, r.data()}) *each = any(generator);
    for (Eigen::Index k = 0; k < p.size(); ++k) p(k) = any(generator);
    const Eigen::Matrix2d mass = eom::mass_matrix(x, p, r);
    Eigen::Matrix<double, 2, 2, Eigen::RowMajor> in_c;
    Eigen::Vector2d forcing;
    crane_mass_matrix_and_forcing(0, x.data(), p.data(), r.data(), in_c.data(), forcing.data());
    largest = (std::max)(largest, (mass - in_c).norm() / mass.norm());
    largest = (std::max)(largest, (eom::forcing(x, p, r) - forcing).norm() / forcing.norm());
  }
  std::printf("M and f of the C++ types and of the C code differ by at most %.1e at 100 random states\n",
              largest);
  if (!(largest < 1e-12)) ++failures;
}

} // namespace

int main(int, char** arguments) {
  const playground::session session(contents_of(arguments[1]));
  const std::string folder = arguments[2];
  compare(playground::write_words(session, "crane"), folder);
  compare(playground::export_c(session, "crane"), folder + "/crane_c");
  compare(playground::export_fmu(session, "crane"), folder + "/crane");
  compare_mass_matrices();
  return failures;
}
