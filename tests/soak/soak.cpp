// A given number of random mechanisms in random units, compared with an independent evaluation.
#include "bound.hpp"
#include "loaded.hpp"
#include "tree.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace {

struct asked {
  unsigned first = 0;
  long trees = 80'000, bound = 20'000, loaded = 3'000;
  soak::wanted wanted;
  std::string folder = "build/soak";
};

struct tally {
  soak::errors errors;
  long compared = 0, left_out = 0, hostile = 0, refused = 0, failed = 0;
};

// Mechanisms of one kind, from a seed on, until the given number has been compared.
template <class Mechanism>
tally go_through(const asked& a, long wanted, const char* kind) {
  tally t;
  for (unsigned seed = a.first; t.compared < wanted; ++seed) {
    Mechanism one(seed);
    if (!one.is_regular()) {
      ++t.left_out;
      continue;
    }
    ++t.compared;
    t.errors.begin(seed);
    one.run(t.errors, a.wanted);
    t.hostile += one.hostile_visited, t.refused += one.hostile_refused;
    if (!t.errors.reason().empty()) {
      ++t.failed;
      std::filesystem::create_directories(a.folder);
      std::ofstream(a.folder + "/failures.txt", std::ios::app)
          << kind << ' ' << seed << ": " << t.errors.reason() << '\n';
      const auto count = [&](std::string_view each) { return each == kind ? 1 : 0; };
      std::printf("%s %u failed: %s; again by: soak --first %u --trees %d --bound %d --loaded %d\n", kind,
                  seed, t.errors.reason().c_str(), seed, count("trees"), count("bound"), count("loaded"));
      std::fflush(stdout);
    }
    if (t.compared % 1000 == 0) {
      std::fprintf(stderr, "%ld %s, %ld failed\n", t.compared, kind, t.failed);
    }
  }
  return t;
}

void print(const tally& t, const char* what, double decades) {
  std::printf("\n%ld %s in units over 1e-%g to 1e%g each of length, mass and time: %ld failed\n", t.compared,
              what, decades, decades, t.failed);
  std::printf("%ld were singular at their state, and left out\n", t.left_out);
  std::printf("%ld hostile states, of which %ld were refused with a sentence\n", t.hostile, t.refused);
  for (const auto& [name, worst] : t.errors.by_what())
    std::printf("  %-30s %8ld compared, worst error %.1e (seed %u)\n", name.c_str(), worst.count, worst.error,
                worst.seed);
}

} // namespace

int main(int count, char** words) {
  asked a;
  CLI::App line("Compares random mechanisms in random units with an independent evaluation");
  line.add_option("--first", a.first, "The first seed");
  line.add_option("--trees", a.trees, "How many without constraints");
  line.add_option("--bound", a.bound, "How many with constraints");
  line.add_option("--loaded", a.loaded, "How many with loads along pathways, in contacts and with states");
  line.add_option("--decades", a.wanted.decades, "Over how many decades units are scaled, to either side");
  line.add_flag("--hostile,!--no-hostile", a.wanted.hostile_states, "Visit hostile states");
  line.add_option("--plant", a.wanted.planted,
                  "Only compare the derivatives of mechanisms one of whose loads is larger by this share; "
                  "those that do not fail hide the error");
  line.add_option("--folder", a.folder, "Where seeds of failures are written");
  CLI11_PARSE(line, count, words);
  const auto begin = std::chrono::steady_clock::now();
  const tally trees = go_through<soak::tree>(a, a.trees, "trees"),
              bound = go_through<soak::bound>(a, a.bound, "bound"),
              loaded = go_through<soak::loaded>(a, a.loaded, "loaded");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  print(trees, "mechanisms without constraints", a.wanted.decades);
  print(bound, "mechanisms with constraints", a.wanted.decades);
  print(loaded, "mechanisms with loads along pathways, in contacts and with states", 0);
  std::printf("\n%.0f s\n", took.count());
  return trees.failed + bound.failed + loaded.failed == 0 ? 0 : 1;
}
