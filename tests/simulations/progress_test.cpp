// builds: clang++
#include <kanexpr/simulations/progress.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>

#include <fcntl.h>

namespace {

using kanexpr::progress_bar;

// A terminal and the text written to it.
class terminal {
public:
  terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(::grantpt(master_), 0);
    EXPECT_EQ(::unlockpt(master_), 0);
    out_ = std::fopen(::ptsname(master_), "w");
    EXPECT_EQ(::fcntl(master_, F_SETFL, O_NONBLOCK), 0);
  }
  ~terminal() {
    std::fclose(out_);
    ::close(master_);
  }
  terminal(const terminal&) = delete;
  terminal& operator=(const terminal&) = delete;

  std::FILE* out() const { return out_; }
  std::string written() {
    char some[4096];
    for (ssize_t n = ::read(master_, some, sizeof some); n > 0; n = ::read(master_, some, sizeof some))
      text_.append(some, static_cast<std::size_t>(n));
    return text_;
  }

private:
  int master_;
  std::FILE* out_ = nullptr;
  std::string text_;
};

constexpr char half[] = "\r[####################....................]  50 %";
constexpr char whole[] = "\r[########################################] 100 %, ";
constexpr char erased[] = "\r\x1b[K";

TEST(progress_bar, draws_a_line_and_ends_it) {
  terminal screen;
  progress_bar bar(screen.out());
  bar(1, 1, 5);
  EXPECT_EQ(screen.written(), "\r[........................................]   0 %\x1b[K");
  std::this_thread::sleep_for(std::chrono::milliseconds(110));
  bar(3, 1, 5);
  EXPECT_NE(screen.written().find(half), std::string::npos) << screen.written();
  EXPECT_TRUE(screen.written().ends_with(" s left\x1b[K"));
  bar(5, 1, 5);
  EXPECT_NE(screen.written().find(whole), std::string::npos) << screen.written();
  EXPECT_TRUE(screen.written().ends_with(" s\x1b[K\r\n"));
}

TEST(progress_bar, draws_at_most_ten_times_a_second) {
  terminal screen;
  progress_bar bar(screen.out());
  const auto begin = std::chrono::steady_clock::now();
  double elapsed = 0;
  while (elapsed < 0.35) {
    bar(elapsed, 0, 1);
    elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  const std::string text = screen.written();
  const auto drawn = std::ranges::count(text, '[') / 2; // each time the bar and the end of the line
  EXPECT_GE(drawn, 2);
  EXPECT_LE(drawn, static_cast<long>(elapsed / 0.1) + 1);
}

TEST(progress_bar, clears_the_line_of_an_incomplete_run) {
  terminal screen;
  {
    progress_bar bar(screen.out());
    bar(3, 1, 5);
    EXPECT_FALSE(screen.written().ends_with(erased));
  }
  EXPECT_TRUE(screen.written().ends_with(erased));
}

TEST(progress_bar, clears_nothing_before_the_start_or_after_the_end) {
  terminal screen;
  {
    progress_bar unused(screen.out());
  }
  EXPECT_EQ(screen.written(), "");
  {
    progress_bar bar(screen.out());
    bar(5, 1, 5);
  }
  EXPECT_TRUE(screen.written().ends_with("\n"));
}

TEST(progress_bar, supports_several_runs_and_times_that_run_backward) {
  terminal screen;
  progress_bar bar(screen.out());
  bar(5, 1, 5);
  const std::size_t before = screen.written().size();
  bar(3, 5, 1);
  EXPECT_EQ(screen.written().find(half, before), before);
  bar(1, 5, 1);
  EXPECT_TRUE(screen.written().ends_with("\n"));
}

struct span {
  double from, to;
};

TEST(progress_bar, is_called_with_a_span_as_a_function) {
  terminal screen;
  const std::function<void(double, span)> progress = progress_bar(screen.out());
  progress(3, {1, 5});
  EXPECT_TRUE(screen.written().starts_with(half)) << screen.written();
}

TEST(progress_bar, writes_nothing_to_a_file) {
  std::FILE* file = std::tmpfile();
  {
    progress_bar bar(file);
    bar(3, 1, 5);
    bar(5, 1, 5);
  }
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

} // namespace
