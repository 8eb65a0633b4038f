// builds: clang++ all
// Reads HDF5 files as other programs do, by functions of HDF5.
#include "ensembles/written_study.hpp"

#include <kanexpr/ensembles/csv_file.hpp>
#include <kanexpr/ensembles/hdf5/handles.ipp>
#include <kanexpr/hdf5.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using kanexpr::csv_file;
using kanexpr::hdf5_file;
using kanexpr::ensembles::hdf5_errors;
using kanexpr::ensembles::hdf5_handle;
using testing::HasSubstr;
using testing::StartsWith;
using testing::TempDir;

// A path in memory, for files that a test writes often.
std::string in_memory(const std::string& name) {
  const std::string folder = std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : TempDir();
  return folder + "/kanexpr_" + std::to_string(::getuid()) + '_' + name;
}

// Reads a file as other programs do, also while it is being written.
class reader {
public:
  explicit reader(const std::string& path) {
    const hdf5_errors errors;
    for (unsigned how : {H5F_ACC_RDONLY, H5F_ACC_RDONLY | H5F_ACC_SWMR_READ})
      if (!file_) file_ = {H5Fopen(path.c_str(), how, H5P_DEFAULT), &H5Fclose};
  }
  explicit operator bool() const { return static_cast<bool>(file_); }

  std::size_t rows(const std::string& name) const {
    const hdf5_handle set = open(name), space(H5Dget_space(set.id()), &H5Sclose);
    return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id()));
  }
  // One column, converted to double.
  std::vector<double> column(const std::string& name, const std::string& of) const {
    std::vector<double> all(rows(name));
    const hdf5_handle one(H5Tcreate(H5T_COMPOUND, sizeof(double)), &H5Tclose);
    H5Tinsert(one.id(), of.c_str(), 0, H5T_NATIVE_DOUBLE);
    read(name, one, all.data());
    return all;
  }
  std::vector<std::array<char, 513>> causes() const {
    std::vector<std::array<char, 513>> all(rows("failures"));
    const hdf5_handle text(H5Tcopy(H5T_C_S1), &H5Tclose), one(H5Tcreate(H5T_COMPOUND, 513), &H5Tclose);
    H5Tset_size(text.id(), 513);
    H5Tset_cset(text.id(), H5T_CSET_UTF8);
    H5Tinsert(one.id(), "cause", 0, text.id());
    read("failures", one, all.data());
    return all;
  }
  // The stored bytes.
  std::string bytes(const std::string& name) const {
    const hdf5_handle set = open(name), type(H5Dget_type(set.id()), &H5Tclose);
    std::string all(rows(name) * H5Tget_size(type.id()), '\0');
    EXPECT_GE(H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), 0);
    return all;
  }
  std::vector<std::string> columns(const std::string& name) const {
    const hdf5_handle set = open(name), type(H5Dget_type(set.id()), &H5Tclose);
    std::vector<std::string> all;
    for (int i = 0; i < H5Tget_nmembers(type.id()); ++i) {
      char* one = H5Tget_member_name(type.id(), static_cast<unsigned>(i));
      all.emplace_back(one);
      H5free_memory(one);
    }
    return all;
  }
  std::vector<std::string> texts(const std::string& name, const char* attribute) const {
    const hdf5_handle of(H5Aopen_by_name(file_.id(), name.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT),
                         &H5Aclose),
        type(H5Aget_type(of.id()), &H5Tclose), space(H5Aget_space(of.id()), &H5Sclose);
    std::vector<char*> all(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    EXPECT_GE(H5Aread(of.id(), type.id(), all.data()), 0);
    const std::vector<std::string> found(all.begin(), all.end());
    H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, all.data());
    return found;
  }
  std::uint64_t number(const std::string& name, const char* attribute) const {
    const hdf5_handle of(H5Aopen_by_name(file_.id(), name.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT),
                         &H5Aclose);
    std::uint64_t found = 0;
    EXPECT_GE(H5Aread(of.id(), H5T_NATIVE_UINT64, &found), 0);
    return found;
  }

private:
  hdf5_handle open(const std::string& name) const {
    return {H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), &H5Dclose};
  }
  void read(const std::string& name, const hdf5_handle& as, void* into) const {
    const hdf5_handle set = open(name);
    EXPECT_GE(H5Dread(set.id(), as.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, into), 0) << name;
  }

  hdf5_handle file_{};
};

constexpr std::array tables{"runs", "failures", "samples", "events"};

void expect_same(const std::string& path, const std::string& other) {
  const reader one(path), two(other);
  ASSERT_TRUE(one && two) << path;
  for (const char* each : tables) EXPECT_TRUE(one.bytes(each) == two.bytes(each)) << path << ' ' << each;
}

/// The file of a study that was not interrupted.
const std::string& whole(const written::study& known) {
  static const std::string path = TempDir() + "whole.h5";
  const auto found = written::run(known, {.files = {hdf5_file(path)}});
  EXPECT_TRUE(found) << found.cause();
  return path;
}

// Calls a function in a separate process, which must print nothing.
class child {
public:
  explicit child(const std::function<void()>& what) : said_(TempDir() + "said") {
    process_ = ::fork();
    if (process_ != 0) return;
    ::dup2(::open(said_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), 2);
    what();
    std::exit(0); // calls the exit handlers of HDF5
  }
  void kill() const { ::kill(process_, SIGKILL); }
  int wait() {
    int how = 0;
    ::waitpid(process_, &how, 0);
    std::ifstream in(said_);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "");
    return how;
  }

private:
  pid_t process_;
  std::string said_;
};

TEST(hdf5_file, has_all_that_a_study_keeps) {
  const written::study known(1000);
  const std::string path = "known_study.h5"; // read by read_hdf5.py
  const auto found = written::run(known, {.threads = 3, .files = {hdf5_file(path)}});
  ASSERT_TRUE(found) << found.cause();
  const reader file(path);
  ASSERT_TRUE(file);

  EXPECT_EQ(file.columns("runs"), found.runs.names());
  EXPECT_EQ(file.texts("runs", "units"), (std::vector<std::string>{"", "", "s", "N s", "rad", "°/s"}));
  EXPECT_EQ(file.texts("runs", "ends"),
            (std::vector<std::string>{"reached_end", "stopped_by_event", "failed"}));
  EXPECT_EQ(file.number("runs", "varied"), 1);
  EXPECT_EQ(file.number(".", "planned_runs"), 1000);
  EXPECT_EQ(file.texts(".", "study"), std::vector<std::string>{"a known study"});
  for (const std::string& each : file.columns("runs"))
    EXPECT_THAT(file.column("runs", each),
                testing::Pointwise(testing::NanSensitiveDoubleEq(), found.runs[each]))
        << each;

  EXPECT_EQ(file.columns("failures"), (std::vector<std::string>{"run_", "t_end", "q", "run", "cause"}));
  const auto failed = file.column("failures", "run_"), q = file.column("failures", "q");
  const auto causes = file.causes();
  ASSERT_EQ(failed.size(), found.failed);
  ASSERT_EQ(failed.size(), 143u);
  EXPECT_TRUE(std::isnan(q[0])); // ended without a state
  EXPECT_EQ(q[2], written::study::pushed(17));
  EXPECT_STREQ(causes[2].data(), "run 17 fell");
  EXPECT_EQ(causes[1].data(), "is long: " + std::string(500, 'x') + "…");

  EXPECT_EQ(file.columns("samples"), (std::vector<std::string>{"run_", "t", "q", "run"}));
  ASSERT_EQ(file.rows("samples"), 2000u);
  EXPECT_EQ(file.column("samples", "run_")[1999], 999);
  EXPECT_EQ(file.column("samples", "t")[1999], 3);
  EXPECT_EQ(file.column("samples", "run")[1999], 0.5 * written::study::pushed(999));

  EXPECT_EQ(file.texts("events", "names"), known.layout().events);
  ASSERT_EQ(file.rows("events"), 668u);
  EXPECT_EQ(file.column("events", "run")[3], 3);
  EXPECT_EQ(file.column("events", "t")[3], 0.75 + written::study::pushed(3));
  EXPECT_EQ(file.column("events", "event")[4], 1);
  EXPECT_EQ(file.column("events", "event")[5], 0);
}

TEST(hdf5_file, is_the_same_by_any_number_of_threads_and_compressed) {
  const written::study known(20000);
  const std::string path = TempDir() + "compressed.h5";
  ASSERT_TRUE(written::run(known, {.threads = 2, .files = {hdf5_file(path, {.compression = 4})}}));
  expect_same(path, whole(known));
  EXPECT_LT(std::filesystem::file_size(path), std::filesystem::file_size(whole(known)) / 2);
}

TEST(hdf5_file, is_of_a_single_run_without_failures) {
  const std::string path = TempDir() + "single.h5";
  ASSERT_TRUE(written::run(written::study(1, false), {.files = {hdf5_file(path)}}));
  const reader file(path);
  EXPECT_EQ(file.rows("runs"), 1u);
  EXPECT_EQ(file.rows("failures"), 0u);
}

TEST(hdf5_file, is_read_by_another_program_while_it_is_written) {
  const std::string path = TempDir() + "growing.h5";
  std::filesystem::remove(path);
  const written::study known(3000);
  child other([&] { // sees the table grow, and only rows that were written
    std::vector<std::size_t> seen;
    while (seen.size() < 3 || seen.back() < 3000) {
      const reader file(path);
      const std::size_t rows = file ? file.rows("runs") : 0;
      const std::vector<double> pushes = file ? file.column("runs", "push") : std::vector<double>();
      for (std::size_t i = 0; i < pushes.size(); ++i)
        if (pushes[i] != written::study::pushed(i)) std::exit(1);
      if (rows > 0 && (seen.empty() || seen.back() != rows)) seen.push_back(rows);
    }
  });
  const auto file = hdf5_file(path, {.flush_every = 0.01});
  ASSERT_TRUE(file->begin(known.layout()));
  for (std::size_t i = 0; i < known.layout().runs; ++i) {
    ASSERT_TRUE(file->take(known.one(i)));
    if (i % 1000 == 500) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_TRUE(file->end());
  EXPECT_EQ(other.wait(), 0);
}

TEST(hdf5_file, goes_on_after_the_program_was_killed) {
  using namespace std::chrono_literals;
  const written::study known(20000);
  const std::string path = in_memory("killed.h5"), checkpoint = in_memory("killed.checkpoint");
  std::filesystem::remove(checkpoint);
  for (int compression : {0, 1}) {
    kanexpr::ensemble_options options{.threads = 2,
                                      .hold = false,
                                      .files = {hdf5_file(path, {compression, 0.01})},
                                      .checkpoint = checkpoint,
                                      .checkpoint_every = 0.005};
    options.progress = [](double, double, double) { std::this_thread::sleep_for(1ms); };
    int interrupted = 0;
    for (int moment = 0; moment < 8; ++moment) {
      std::error_code none_yet;
      const auto before = std::filesystem::last_write_time(checkpoint, none_yet);
      child writer([&] { static_cast<void>(written::run(known, options)); });
      for (int i = 0; i < 2000 && std::filesystem::last_write_time(checkpoint, none_yet) == before; ++i)
        std::this_thread::sleep_for(1ms);
      std::this_thread::sleep_for(moment * 1.3ms);
      writer.kill();
      interrupted += WIFSIGNALED(writer.wait());
    }
    EXPECT_GT(interrupted, 4);
    EXPECT_GT(reader(path).rows("runs"), 0u);
    options.progress = {};
    const auto found = written::run(known, options);
    ASSERT_TRUE(found) << found.cause();
    expect_same(path, whole(known));
  }
  std::filesystem::remove(path);
}

TEST(hdf5_file, does_not_go_on_in_a_shorter_file) {
  const std::string path = in_memory("changed.h5"), noted = path + ".noted";
  const written::study known(3000);
  for (int compression : {0, 1}) {
    const auto file = hdf5_file(path, {compression});
    std::string position;
    ASSERT_TRUE(file->begin(known.layout()));
    for (const auto& each : known.run(0, 2000)) ASSERT_TRUE(file->take(each));
    ASSERT_TRUE(file->flush(position));
    const auto size = std::filesystem::file_size(path);
    for (const auto& each : known.run(2000, 500)) ASSERT_TRUE(file->take(each));
    ASSERT_TRUE(file->end());
    std::filesystem::copy_file(path, noted, std::filesystem::copy_options::overwrite_existing);

    for (std::uintmax_t left : {size - 1, size / 10}) { // an interrupted copy
      std::filesystem::copy_file(noted, path, std::filesystem::copy_options::overwrite_existing);
      std::filesystem::resize_file(path, left);
      EXPECT_FALSE(file->resume(known.layout(), position)) << left << " of " << size << " bytes";
    }
    ASSERT_TRUE(file->begin(known.layout())); // of a study with fewer runs
    for (const auto& each : known.run(0, 1900)) ASSERT_TRUE(file->take(each));
    ASSERT_TRUE(file->end());
    EXPECT_EQ(file->resume(known.layout(), position).cause(),
              path + " has changed since the checkpoint was written");

    std::filesystem::copy_file(noted, path, std::filesystem::copy_options::overwrite_existing);
    ASSERT_TRUE(file->resume(known.layout(), position));
    for (const auto& each : known.run(2000, 1000)) ASSERT_TRUE(file->take(each));
    ASSERT_TRUE(file->end());
    expect_same(path, whole(known));
  }
  std::filesystem::remove(path), std::filesystem::remove(noted);
}

TEST(hdf5_file, is_written_where_a_link_leads_and_replaces_files_alone) {
  const std::filesystem::path folder = TempDir() + "kanexpr_links";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "scratch");
  const std::string link = folder / "link.h5", pipe = folder / "pipe";
  std::ofstream(folder / "scratch" / "study.h5").close();
  std::filesystem::create_symlink("scratch/study.h5", link);
  const written::study known(10);
  ASSERT_EQ(written::run(known, {.files = {hdf5_file(link)}}).cause(), "");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(reader(folder / "scratch" / "study.h5").rows("runs"), 10u);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(written::run(known, {.files = {hdf5_file(pipe)}}).cause(), pipe + " is not a regular file");
  EXPECT_EQ(written::run(known, {.files = {hdf5_file(folder.string())}}).cause(),
            folder.string() + " is not a regular file");
  std::filesystem::remove_all(folder);
}

TEST(hdf5_file, ends_where_a_study_is_asked_to_stop_before_it_was_interrupted) {
  const written::study known(100);
  const std::string path = TempDir() + "stopped.h5";
  std::string position;
  {
    const auto file = hdf5_file(path);
    ASSERT_TRUE(file->begin(known.layout()));
    for (std::size_t i = 0; i < 80; ++i) {
      if (i == 40) {
        ASSERT_TRUE(file->flush(position));
      }
      ASSERT_TRUE(file->take(known.one(i)));
    }
  }
  EXPECT_EQ(reader(path).rows("runs"), 80u);
  const auto file = hdf5_file(path);
  ASSERT_TRUE(file->resume(known.layout(), position));
  for (std::size_t i = 40; i < 50; ++i) ASSERT_TRUE(file->take(known.one(i)));
  EXPECT_TRUE(file->end());
  EXPECT_EQ(reader(path).rows("runs"), 50u);
  EXPECT_EQ(reader(path).rows("failures"), 7u);
}

void limit_files(rlim_t most) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{most, most};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(hdf5_file, goes_on_when_a_full_disk_has_space_again) {
  const written::study known(20000);
  const std::string path = in_memory("full.h5"), checkpoint = in_memory("full.checkpoint");
  for (rlim_t most : {700'000u, 2'000'001u}) {
    std::filesystem::remove(checkpoint);
    std::filesystem::remove(path);
    const kanexpr::ensemble_options options{.hold = false,
                                            .files = {hdf5_file(path, {.flush_every = 0.01})},
                                            .checkpoint = checkpoint,
                                            .checkpoint_every = 0.001};
    child writer([&] {
      limit_files(most);
      const auto found = written::run(known, options);
      if (found.cause() != path + " cannot be written: File too large") std::cerr << found.cause();
    });
    EXPECT_EQ(writer.wait(), 0);
    EXPECT_TRUE(std::filesystem::exists(checkpoint));
    const auto found = written::run(known, options);
    ASSERT_TRUE(found) << found.cause();
    expect_same(path, whole(known));
  }
  std::filesystem::remove(path);
}

TEST(hdf5_file, ends_with_a_sentence_whichever_write_fails) {
  const written::study known(2000);
  const std::string path = in_memory("any.h5");
  for (int compression : {0, 1})
    for (rlim_t most = 100; most < 120'000; most = most * 3 / 2) {
      child writer([&] {
        limit_files(most);
        const auto file = hdf5_file(path, {compression, 0.001});
        kanexpr::outcome done = file->begin(known.layout());
        for (std::size_t i = 0; i < 2000 && done; ++i) done = file->take(known.one(i));
        if (done) done = file->end();
        if (done.cause() != path + " cannot be written: File too large") std::cerr << most << done.cause();
      });
      EXPECT_EQ(writer.wait(), 0) << most;
    }
  std::filesystem::remove(path);
}

TEST(hdf5_file, says_what_it_cannot) {
  const written::study known(10);
  const auto cause = [&](const std::string& path, const kanexpr::hdf5_options& options = {}) {
    return written::run(known, {.files = {hdf5_file(path, options)}}).cause();
  };
  EXPECT_EQ(cause("/nowhere/study.h5"), "/nowhere/study.h5 cannot be written: No such file or directory");
  const std::string path = TempDir() + "mistaken.h5";
  EXPECT_EQ(cause(path, {.compression = 12}), path + " cannot be written: invalid deflate level");
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
  EXPECT_THAT(written::run(known, {.files = {hdf5_file(path), csv_file("some.csv")}}).cause(),
              StartsWith("some.csv cannot hold the trajectories"));
  EXPECT_FALSE(std::filesystem::exists(path));

  kanexpr::study_layout wide = known.layout();
  for (int i = 0; i < 3000; ++i) wide.columns.push_back({"a long name of a column " + std::to_string(i)});
  EXPECT_EQ(hdf5_file(path)->begin(wide).cause(),
            path + " cannot be written: object header message is too large");
  wide.columns = {{"run"}, {"end"}, {"t_end"}, {"twice"}, {"twice"}};
  EXPECT_EQ(hdf5_file(path)->begin(wide).cause(), path + " cannot be written: member name is not unique");

  ASSERT_EQ(cause(path), "");
  const auto here = hdf5_file(path);
  EXPECT_THAT(here->resume(wide, "").cause(), StartsWith(path + " cannot be opened: "));
  std::string position(40, '\0');
  position[9] = 1; // 256 rows
  EXPECT_EQ(here->resume(known.layout(), position).cause(),
            path + " has changed since the checkpoint was written");
  EXPECT_TRUE(reader(path));
  std::ofstream(path) << "something else";
  EXPECT_EQ(here->resume(known.layout(), "").cause(), path + " cannot be opened: file signature not found");
  std::filesystem::remove(path);
  EXPECT_EQ(here->resume(known.layout(), "").cause(), path + " cannot be opened: No such file or directory");
}

TEST(hdf5_file, takes_a_million_runs) {
  const written::study known(1, false);
  const std::string path = TempDir() + "million.h5";
  const auto file = hdf5_file(path);
  ASSERT_TRUE(file->begin(known.layout()));
  kanexpr::finished_run one = known.one(0);
  const auto before = std::chrono::steady_clock::now();
  for (one.run = 0; one.run < 1'000'000; ++one.run) static_cast<void>(file->take(one));
  EXPECT_TRUE(file->end());
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - before;
  std::cout << took.count() / 1e6 << " ns a row of " << one.values.size() << " numbers\n";
  EXPECT_EQ(reader(path).rows("runs"), 1'000'000u);
  std::filesystem::remove(path);
}

} // namespace
