// A study on several ranks, one of which may crash: `study FILE [word=value]…` writes the table.
#include <kanexpr/ensembles/run_on_threads.hpp>
#include <kanexpr/ensembles/stop_on_signal.hpp>
#include <kanexpr/mpi/mpi_ranks.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <thread>

namespace {

using namespace kanexpr;

std::map<std::string, std::string> words; // of the command line

std::string value(const std::string& word) {
  const auto found = words.find(word);
  return found == words.end() ? "" : found->second;
}

double number(const std::string& word, double otherwise) {
  return words.contains(word) ? std::stod(value(word)) : otherwise;
}

bool is_this(const std::string& word, std::size_t what) { return value(word) == std::to_string(what); }

/// Chaotic numbers, which show every difference between runs. Some runs take 100 times as long as others.
class logistic_maps final : public ensembles::study_interface {
public:
  explicit logistic_maps(std::size_t rank) : rank_(rank) {
    layout_.study = value("study");
    layout_.runs = static_cast<std::size_t>(number("runs", 1500));
    layout_.columns = {{"run"}, {"end"}, {"t_end", "s"}, {"rate"}, {"mean"}};
    layout_.samples = {{"t", "s"}};
  }
  const study_layout& layout() const override { return layout_; }
  std::string identity() const override { return is_this("odd_rank", rank_) ? "another" : value("seed"); }
  std::size_t lanes() const override { return 4; }
  std::vector<finished_run> run(std::size_t first, std::size_t count) const override {
    std::vector<finished_run> all;
    for (std::size_t i = first; i < first + count; ++i) all.push_back(one(i));
    return all;
  }

private:
  finished_run one(std::size_t run) const {
    if (is_this("bad_rank", rank_) && run >= 200) end_badly(value("how"));
    const bool waits = words.contains("bad_rank") ? run >= 400 : words.contains("stop_at") && run >= 1000;
    while (waits && !std::filesystem::exists(value("mark")))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    finished_run done;
    done.run = run;
    const auto place = static_cast<double>(run);
    const double rate = 3.5 + 0.5 * std::fmod(place * 0.6180339887498949, 1);
    const auto steps = static_cast<int>(number("steps", 20'000)) / (1 + static_cast<int>(run % 100));
    double x = 0.5, sum = 0;
    for (int i = 0; i < steps; ++i) x = rate * x * (1 - x), sum += std::sin(x);
    done.time = x;
    done.values = {place, run % 7 == 3 ? 2.0 : 0.0, x, rate, sum};
    done.samples.assign(run % 50 == 0 ? 3000 : 1, x); // some are too long for MPI to send in one message
    if (run % 7 != 3) return done;
    done.end = run_end::failed;
    done.failure = "every seventh run fails";
    return done;
  }

  /// The other ranks wait for the mark.
  static void end_badly(const std::string& how) {
    const std::ofstream mark(value("mark"));
    std::raise(how == "kill" ? SIGKILL : SIGSEGV);
  }

  std::size_t rank_;
  study_layout layout_{};
};

void write(const ensemble_results& found, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  for (std::size_t i = 0; i < found.runs.columns(); ++i)
    for (double each : found.runs.values(i)) out.write(reinterpret_cast<const char*>(&each), sizeof each);
  for (const table& each : found.trajectories)
    out.write(reinterpret_cast<const char*>(each.values(0).data()),
              static_cast<std::streamsize>(each.values(0).size() * sizeof(double)));
  for (const failed_run& each : found.failures) out << each.run << ' ' << each.cause << '\n';
}

} // namespace

int main(int argc, char** argv) {
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    const auto behind = word.find('=');
    words[word.substr(0, behind)] = word.substr(behind + 1);
  }
  mpi_ranks ranks(argc, argv);
  const auto rank = static_cast<std::size_t>(ranks.rank());
  const logistic_maps study(rank);
  const stop_on_signal stop({SIGTERM, SIGUSR1});
  ensemble_options options{.threads = static_cast<unsigned>(number("threads", 1)), .stop = stop.token()};
  if (words.contains("checkpoint")) options.checkpoint = value("checkpoint");
  options.checkpoint_every = 0;
  options.progress = [&](double done, double, double) {
    if (done < number("stop_at", 1e9)) return;
    std::raise(SIGTERM);
    while (!stop.token().stop_requested()) std::this_thread::yield();
    const std::ofstream mark(value("mark"));
  };
  if (is_this("absent_rank", rank)) return 0;
  const ensemble_results found =
      words.contains("alone") ? ensembles::run_on_threads(study, options) : ranks.run(study, options);
  if (!found) std::cout << "rank " << ranks.rank() << ": " << found.cause() << '\n';
  if (ranks.is_first()) write(found, argv[1]);
  return found ? 0 : 1;
}
