// builds: clang++
#include <kanexpr/ensembles/run_on_threads.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>

#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace kanexpr;
namespace files = std::filesystem;

// A study whose runs take no time. Run 5 fails, and every third run has an event.
class squares final : public ensembles::study_interface {
public:
  explicit squares(std::size_t count, std::string identity = "by this", const char* name = "squares")
      : identity_(std::move(identity)) {
    layout_.study = name, layout_.runs = count, layout_.columns = {{"run"}, {"square", "m2"}};
    layout_.state = {{"q"}}, layout_.samples = {{"t", "s"}, {"q"}}, layout_.events = {"third"};
  }
  const study_layout& layout() const override { return layout_; }
  std::string identity() const override { return identity_; }
  std::size_t lanes() const override { return 1; }
  std::vector<finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<finished_run> all(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto number = static_cast<double>(first + i);
      all[i].run = first + i;
      all[i].values = {number, number * number};
      for (std::size_t k = 0; k <= (first + i) % 4; ++k)
        all[i].samples.insert(all[i].samples.end(), {double(k), number});
      if ((first + i) % 3 == 0) all[i].events = {{0, number / 7}};
      if (first + i == 5)
        all[i].end = run_end::failed, all[i].state = {2.5}, all[i].failure = "it is the fifth";
    }
    return all;
  }

private:
  std::string identity_;
  study_layout layout_{};
};

class checkpoint : public testing::Test {
protected:
  void SetUp() override { files::remove_all(folder), files::create_directories(folder); }
  void TearDown() override { files::remove_all(folder); }

  // Stops after this many runs; 0: performs all.
  ensemble_results run(std::size_t until = 0, unsigned threads = 1, std::string known_by = "by this") const {
    const auto stop =
        std::make_shared<std::stop_source>(); // g++ 12 reports one on the stack as uninitialized
    ensemble_options options{.threads = threads,
                             .reduce = {statistics_of("square"), quantiles_of("square")},
                             .checkpoint = path,
                             .progress =
                                 [&](double done, double, double) {
                                   if (until > 0 && done >= double(until)) stop->request_stop();
                                 },
                             .stop = stop->get_token()};
    return ensembles::run_on_threads(squares(count, std::move(known_by)), options);
  }

  static constexpr std::size_t count = 1000;
  const files::path folder = files::path(testing::TempDir()) / "kanexpr_checkpoint";
  const std::string path = (folder / "study.checkpoint").string();
};

void expect_whole(const ensemble_results& found) {
  ASSERT_TRUE(found) << found.cause();
  ASSERT_EQ(found.runs.rows(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(found.runs["square"][i], double(i * i));
    ASSERT_EQ(found.trajectories[i].rows(), i % 4 + 1);
    EXPECT_EQ(found.trajectories[i]["q"].back(), double(i));
    EXPECT_EQ(found.events[i].size(), i % 3 == 0 ? 1u : 0u);
  }
  ASSERT_EQ(found.failures.size(), 1u);
  EXPECT_EQ(found.failures[0].run, 5u);
  EXPECT_EQ(found.failures[0].cause, "it is the fifth");
  EXPECT_THAT(found.failures[0].state, testing::ElementsAre(2.5));
  EXPECT_EQ(found.statistics("square").count(), 999u);
  EXPECT_EQ(found.quantiles("square").quantile(1), 999.0 * 999);
}

TEST_F(checkpoint, is_where_an_interrupted_study_goes_on) {
  const auto first = run(100);
  EXPECT_FALSE(first);
  EXPECT_GE(first.done, 100u);
  EXPECT_LT(first.done, count);
  EXPECT_EQ(first.runs.rows(), first.done); // finished runs are kept
  EXPECT_EQ(first.cause(), "the study was stopped after " + std::to_string(first.done) + " of 1000 runs");
  const auto second = run(400);
  EXPECT_GT(second.done, first.done);
  EXPECT_FALSE(second);
  expect_whole(run(0, 5));
  EXPECT_TRUE(files::is_empty(folder)); // removed on completion
}

TEST_F(checkpoint, is_written_where_a_link_leads) {
  const files::path scratch = folder / "scratch";
  files::create_directory(scratch);
  std::ofstream(scratch / "note").close();
  files::create_symlink("scratch/note", path);
  EXPECT_FALSE(run(100));
  EXPECT_TRUE(files::is_symlink(path));
  EXPECT_TRUE(files::is_regular_file(scratch / "note"));
  expect_whole(run());
  EXPECT_TRUE(files::is_empty(scratch));
}

TEST_F(checkpoint, of_another_study_is_refused) {
  const std::size_t done = run(100).done;
  for (const auto& other :
       {run(0, 1, "by that"),
        ensembles::run_on_threads(
            squares(count, "by this", "of a name that differs"),
            {.reduce = {statistics_of("square"), quantiles_of("square")}, .checkpoint = path})}) {
    EXPECT_FALSE(other);
    EXPECT_EQ(other.cause(),
              path + " belongs to a different study, model or version of kanexpr; remove it to start over");
    EXPECT_EQ(other.done, 0u);
  }
  EXPECT_GT(run(done + 1).done, done); // the checkpoint remains
}

TEST_F(checkpoint, that_is_damaged_is_refused) {
  static_cast<void>(run(100));
  files::resize_file(path, 30);
  EXPECT_EQ(run().cause(), path + " is damaged");
  std::ofstream(path) << "kanexpr checkpoint 1\nof an older version";
  EXPECT_EQ(run().cause(),
            path + " belongs to a different study, model or version of kanexpr; remove it to start over");
  std::ofstream(path) << "t,q\n0,1\n";
  EXPECT_EQ(run().cause(), path + " is not a checkpoint of a study");
}

TEST_F(checkpoint, that_is_empty_begins_anew) {
  std::ofstream(path).close();
  static_cast<void>(run(100));
  EXPECT_GT(files::file_size(path), 0u);
  expect_whole(run());
}

TEST_F(checkpoint, at_a_path_that_cannot_be_one_is_refused) {
  const auto cause_at = [](const std::string& at) {
    return ensembles::run_on_threads(squares(10), {.checkpoint = at}).cause();
  };
  EXPECT_EQ(cause_at(""), "the path of a file is empty");
  for (const std::string& each : {folder.string(), folder.string() + '/', std::string(".")})
    EXPECT_EQ(cause_at(each), each + " is not a regular file");
  EXPECT_EQ(cause_at("/dev/null"), "/dev/null is not a regular file");
  EXPECT_TRUE(files::is_empty(folder));
}

TEST_F(checkpoint, stays_where_it_was_when_the_program_changes_its_folder) {
  const files::path before = files::current_path(), elsewhere = folder / "elsewhere";
  files::create_directory(elsewhere);
  files::current_path(folder);
  std::stop_source stop;
  const auto found =
      ensembles::run_on_threads(squares(count), {.threads = 1,
                                                 .reduce = {statistics_of("square"), quantiles_of("square")},
                                                 .checkpoint = files::path(path).filename(),
                                                 .checkpoint_every = 0,
                                                 .progress =
                                                     [&](double done, double, double) {
                                                       files::current_path(elsewhere);
                                                       if (done > 100) stop.request_stop();
                                                     },
                                                 .stop = stop.get_token()});
  files::current_path(before);
  EXPECT_LT(found.done, count);
  EXPECT_TRUE(files::is_empty(elsewhere));
  expect_whole(run());
}

TEST_F(checkpoint, does_not_mind_what_a_killed_study_left) {
  const ::pid_t other = ::fork();
  if (other == 0) {
    static_cast<void>(ensembles::run_on_threads(squares(count),
                                                {.threads = 1,
                                                 .reduce = {statistics_of("square"), quantiles_of("square")},
                                                 .checkpoint = path,
                                                 .checkpoint_every = 0,
                                                 .progress = [](double done, double, double) {
                                                   if (done > 100) std::raise(SIGKILL);
                                                 }}));
    ::_exit(1);
  }
  int how = 0;
  ASSERT_EQ(::waitpid(other, &how, 0), other);
  ASSERT_TRUE(WIFSIGNALED(how));
  EXPECT_GT(run(1).done, 1u); // the study resumes
  expect_whole(run());
  EXPECT_TRUE(files::is_empty(folder));
}

TEST_F(checkpoint, that_cannot_be_written_is_told_before_the_first_run) {
  files::remove_all(folder);
  const auto found = run();
  EXPECT_EQ(found.cause(), path + " cannot be written: No such file or directory");
  EXPECT_EQ(found.done, 0u);
}

TEST_F(checkpoint, is_written_from_time_to_time) {
  std::size_t seen = 0;
  const auto found = ensembles::run_on_threads(
      squares(count),
      {.threads = 1, .checkpoint = path, .checkpoint_every = 0, .progress = [&](double, double, double) {
         seen += files::exists(path);
       }});
  ASSERT_TRUE(found) << found.cause();
  EXPECT_GT(seen, 1u);
}

TEST(results, that_are_not_held_are_not_there) {
  const auto found =
      ensembles::run_on_threads(squares(100), {.hold = false, .reduce = {statistics_of("square")}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found.runs.columns(), 0u);
  EXPECT_TRUE(found.trajectories.empty() && found.events.empty());
  EXPECT_EQ(found.statistics("square").count(), 99u);
  EXPECT_EQ(found.failed, 1u);
}

TEST(results, are_told_of_as_they_come) {
  std::vector<double> told;
  const auto found = ensembles::run_on_threads(
      squares(100), {.threads = 3, .progress = [&](double done, double from, double to) {
                       EXPECT_EQ(from, 0);
                       EXPECT_EQ(to, 100);
                       told.push_back(done);
                     }});
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.back(), 100);
}

TEST(results, end_with_a_sentence_whatever_is_thrown) {
  enum class step { begin, take, end };
  struct thrower final : results_file {
    step at;
    explicit thrower(step when) : at(when) {}
    outcome throw_at(step now) const {
      if (now == at) throw 5;
      return {};
    }
    outcome begin(const study_layout&) override { return throw_at(step::begin); }
    outcome resume(const study_layout&, const std::string&) override { return {}; }
    outcome take(const finished_run&) override { return throw_at(step::take); }
    outcome flush(std::string&) override { return {}; }
    outcome end() override { return throw_at(step::end); }
  };
  const auto cause = [](const ensemble_options& options) {
    return ensembles::run_on_threads(squares(100), options).cause();
  };
  const std::string expected = "the results of the study could not be processed: something other than a "
                               "std::exception was thrown";
  EXPECT_EQ(cause({.progress = [](double, double, double) { throw 5; }}), expected);
  for (const step each : {step::begin, step::take, step::end})
    EXPECT_EQ(cause({.files = {std::make_shared<thrower>(each)}}), expected);
}

TEST(results, that_progress_throws_at_are_kept) {
  const auto found = ensembles::run_on_threads(
      squares(100), {.progress = [](double, double, double) { throw std::runtime_error("no paper"); }});
  EXPECT_EQ(found.cause(), "the results of the study could not be processed: no paper");
  EXPECT_GT(found.done, 0u);
  EXPECT_EQ(found.runs.rows(), found.done);
}

} // namespace
