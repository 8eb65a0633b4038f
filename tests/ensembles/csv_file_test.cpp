#include "ensembles/written_study.hpp"

#include <kanexpr/ensembles/csv_file.hpp>
#include <kanexpr/ensembles/exclusive_file.hpp>
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

// Asks to stop when so many runs are done.
struct stopped {
  std::stop_source source{};
  kanexpr::ensemble_options after(double runs, kanexpr::ensemble_options options) {
    options.stop = source.get_token();
    options.threads = 1; // another thread could do the rest meanwhile
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
}

TEST(csv_file, is_no_other_file_of_its_study) {
  const std::filesystem::path folder = std::filesystem::path(TempDir()) / "kanexpr_names";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string one = folder / "one", same = folder / "." / "one", link = folder / "link";
  std::filesystem::create_symlink("one", link);
  const auto cause = [](const kanexpr::ensemble_options& options) {
    return written::run(written::study(10, false), options).cause();
  };
  for (const std::string& file : {one, same, link})
    EXPECT_EQ(cause({.files = {csv_file(file)}, .checkpoint = one}), file + " is in use by another study");
  EXPECT_FALSE(std::filesystem::exists(one));
  EXPECT_EQ(cause({.files = {csv_file(one), csv_file(same)}}), same + " is in use by another study");
  std::filesystem::remove_all(folder);
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
  std::ofstream(path, std::ios::app) << "half a ro"; // behind the checkpoint
  const auto rest = written::run(known, options);
  EXPECT_TRUE(rest) << rest.cause();
  EXPECT_EQ(text_of(path), text_of(whole));
}

TEST(csv_file, does_not_go_on_behind_the_rows_of_another_study) {
  const std::string path = TempDir() + "noted.csv", other = TempDir() + "other.csv";
  const written::study known(5000, false);
  kanexpr::ensemble_options options{
      .threads = 1, .files = {csv_file(path)}, .checkpoint = TempDir() + "noted.checkpoint"};
  ASSERT_FALSE(written::run(known, stopped().after(2000, options)));
  const std::string noted = text_of(path);
  std::string rows = noted;
  rows[rows.rfind(',') - 1] ^= 1; // a digit
  rows += rows.substr(rows.find('\n') + 1);
  std::ofstream(path, std::ios::binary) << rows;
  std::ofstream(other, std::ios::binary) << rows;
  EXPECT_EQ(written::run(known, options).cause(), path + " has changed since the checkpoint was written");
  options.files = {csv_file(other)};
  EXPECT_EQ(written::run(known, options).cause(), other + " has changed since the checkpoint was written");
  EXPECT_EQ(text_of(path), rows); // as they were
  EXPECT_EQ(text_of(other), rows);

  std::ofstream(other, std::ios::binary) << noted; // moved
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

  const std::string path = TempDir() + "held.csv";
  kanexpr::ensembles::exclusive_file first, second;
  EXPECT_TRUE(first.claim(path));
  EXPECT_EQ(second.claim(path).cause(), path + " is in use by another study");
  EXPECT_EQ(cause(path), path + " is in use by another study");
  first.release();
  EXPECT_TRUE(second.claim(path));
  second.release();
  EXPECT_FALSE(std::filesystem::exists(path + ".lock"));

  std::string position(24, '\0');
  position[0] = 100;
  EXPECT_EQ(csv_file(path)->resume(known.layout(), position).cause(),
            path + " has changed since the checkpoint was written");
}

} // namespace
