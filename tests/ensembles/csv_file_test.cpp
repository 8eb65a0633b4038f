// builds: clang++
#include "ensembles/written_study.hpp"

#include <kanexpr/ensembles/csv_file.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

using kanexpr::csv_file;
using testing::HasSubstr;
using testing::TempDir;

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Requests a stop after a number of runs.
struct stopped {
  std::stop_source source{};
  kanexpr::ensemble_options after(double runs, kanexpr::ensemble_options options) {
    options.stop = source.get_token();
    options.threads = 1; // another thread could perform the remaining runs
    options.progress = [this, runs](double done, double, double) {
      if (done >= runs) source.request_stop();
    };
    return options;
  }
};

TEST(csv_file, has_the_table_of_runs) {
  const std::string path = TempDir() + "study.csv";
  const auto found = written::run(written::study(100, false), {.files = {csv_file(path)}});
  ASSERT_TRUE(found) << found.cause();
  const auto read = kanexpr::read_csv(path);
  ASSERT_TRUE(read) << read.cause();
  EXPECT_EQ(read.names(), found.runs.names());
  std::ostringstream held;
  ASSERT_TRUE(kanexpr::write_csv(found.runs, held));
  EXPECT_EQ(text_of(path), held.str());
  EXPECT_TRUE(text_of(path).starts_with("run,end,t_end [s],push [N s],q [rad],\"u/ω \"\"fast\"\" [°/s]\"\n"));
  ASSERT_TRUE(written::run(written::study(1, false), {.files = {csv_file(path, {.with_units = false})}}));
  EXPECT_TRUE(text_of(path).starts_with("run,end,t_end,push,q,\"u/ω \"\"fast\"\"\"\n"));
}

TEST(csv_file, goes_on_where_a_study_was_noted) {
  const std::string path = TempDir() + "noted.csv", whole = TempDir() + "whole.csv";
  const written::study known(5000, false);
  ASSERT_TRUE(written::run(known, {.files = {csv_file(whole)}}));
  const kanexpr::ensemble_options options{
      .threads = 2, .files = {csv_file(path)}, .checkpoint = TempDir() + "noted.checkpoint"};
  std::filesystem::remove(options.checkpoint->text());
  const auto first = written::run(known, stopped().after(1000, options));
  ASSERT_FALSE(first);
  EXPECT_THAT(first.cause(), HasSubstr("the study was stopped after "));
  std::ofstream(path, std::ios::app) << "half a ro"; // after the position of the checkpoint
  const auto rest = written::run(known, options);
  EXPECT_TRUE(rest) << rest.cause();
  EXPECT_EQ(text_of(path), text_of(whole));
}

TEST(csv_file, does_not_go_on_in_a_shorter_file) {
  const std::string path = TempDir() + "noted.csv", other = TempDir() + "other.csv";
  const written::study known(5000, false);
  kanexpr::ensemble_options options{
      .threads = 1, .files = {csv_file(path)}, .checkpoint = TempDir() + "noted.checkpoint"};
  ASSERT_FALSE(written::run(known, stopped().after(2000, options)));
  std::filesystem::copy_file(path, other, std::filesystem::copy_options::overwrite_existing);
  const auto size = std::filesystem::file_size(path);
  std::filesystem::resize_file(path, size - 1);
  EXPECT_EQ(written::run(known, options).cause(), path + " has changed since the checkpoint was written");
  EXPECT_EQ(std::filesystem::file_size(path), size - 1); // unchanged
  std::filesystem::remove(path);
  EXPECT_EQ(written::run(known, options).cause(), path + " has changed since the checkpoint was written");

  options.files = {csv_file(other)}; // moved
  const auto rest = written::run(known, options);
  EXPECT_TRUE(rest) << rest.cause();
}

TEST(csv_file, says_what_it_cannot) {
  const written::study known(10, false);
  const auto cause = [&](const std::string& path, bool keeps_all = false) {
    return written::run(written::study(10, keeps_all), {.files = {csv_file(path)}}).cause();
  };
  EXPECT_EQ(cause("/nowhere/study.csv"), "/nowhere/study.csv cannot be opened: No such file or directory");
  EXPECT_EQ(cause("some.csv", true),
            "some.csv cannot hold the trajectories that the study keeps; use an HDF5 file");
  EXPECT_THAT(cause("/dev/full"), HasSubstr("writing /dev/full failed"));

  const std::string path = TempDir() + "none.csv";
  std::string position(16, '\0');
  position[0] = 100;
  EXPECT_EQ(csv_file(path)->resume(known.layout(), position).cause(),
            path + " has changed since the checkpoint was written");
}

} // namespace
