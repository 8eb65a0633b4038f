// builds: clang++ all
// Flexible bodies from files: docs/guide/flexible-body-files.md.
#include <docs/guide/flexible-body-files/satellite.cpp>

#include <kanexpr/flexible/read_modes.hpp>
#include <kanexpr/flexible/read_sid.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/model.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

#include <docs/guide/flexible-body-files/rod.cpp>

#include <docs/guide/flexible-body-files/stop.cpp>

struct Stop : flexible_body<Stop, O, N, stop> {};
using stop_system = kane_system<inertial<N>, bodies<Stop>>;
using rod_system = kane_system<inertial<N>, bodies<Rod>>;

TEST(flexible_body_files, are_compiled) {
#include <docs/guide/flexible-body-files/amplitudes.cpp>
  EXPECT_EQ(rates.size(), 6);
  EXPECT_TRUE(rates.allFinite());
  EXPECT_GT(moved.norm(), 0);
}

/// A rod of one amplitude, whose modal mass is 1.
TEST(flexible_body_files, are_written_by_hand) {
  using eom = equations_of_motion<rod_system>;
  const eom::state x{{q_of<Rod>, 1e-3}, {u_of<Rod>, 0}};
  EXPECT_NEAR(eom::udot(x)(0), -5e6 * 1e-3, 1e-6);
  EXPECT_NEAR((function<rod_system, position_of<End, O>>{}(x))(0), 2.001, 1e-15);
  using hardening = equations_of_motion<stop_system>;
  const hardening::state at_stop{{q_of<Stop>, 0.1}, {u_of<Stop>, 0}};
  EXPECT_NEAR(hardening::udot(at_stop)(0), -5e6 * 0.1 - 4 * 2e8 * 1e-3, 1e-6);
}

TEST(flexible_body_files, are_read_while_the_program_runs) {
  std::filesystem::current_path(KANEXPR_FLEXIBLE_FILES);
#include <docs/guide/flexible-body-files/run_time.cpp>
  ASSERT_TRUE(read) << read.cause();
  ASSERT_EQ(b.check().view(), "");
  EXPECT_EQ(equations.mass_matrix().rows, 2);
}

TEST(flexible_body_files, are_written_by_python) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("kanexpr_modes_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::filesystem::current_path(folder);
  const std::string script = std::string(KANEXPR_SNIPPETS) + "/docs/guide/flexible-body-files/modes.python";
  if (std::system(("/usr/bin/python3 '" + script + "' 2> python_errors").c_str()) != 0)
    GTEST_SKIP() << "Python has no NumPy";
#include <docs/guide/flexible-body-files/read_modes.cpp>
  ASSERT_TRUE(boom) << boom.cause();
  EXPECT_NEAR(boom.data.mass, 3, 1e-12);
  EXPECT_NEAR(boom.data.first_moment.constant(0), 3, 1e-12);
  EXPECT_NEAR(boom.data.modal_mass[0], 3 * 16 / 5.0, 0.05);
  EXPECT_EQ(boom.data.nodes.size(), 2);
  std::filesystem::current_path(KANEXPR_FLEXIBLE_FILES);
  std::filesystem::remove_all(folder);
}

} // namespace
