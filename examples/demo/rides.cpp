#include "demo/parts.hpp"
#include "demo/ride.hpp"

#include <kanexpr/simulations/tables/csv.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>

/// A bicycle is pushed to the side at three speeds, with three different endings.
namespace demo {

namespace {

constexpr double push = 0.4; // rad/s
constexpr double degree = std::numbers::pi / 180;

double largest_lean(const ride& r, double from, double to) {
  double largest = 0;
  for (const auto& s : r.trajectory)
    if (s.t >= from && s.t <= to) largest = std::max(largest, std::abs(s.x[bicycle::q2]));
  return largest;
}

enum class ending { dies_out, grows, falls, other };

ending ending_of(const ride& r) {
  if (r.stopped_by_event) return ending::falls;
  const double at_first = largest_lean(r, 0, 1), at_last = largest_lean(r, r.time - 2, r.time);
  return at_last < 0.05 * at_first ? ending::dies_out
         : at_last > 2 * at_first  ? ending::grows
                                   : ending::other;
}

const char* sentence_of(ending e) {
  switch (e) {
  case ending::dies_out: return "The swing from side to side dies out.";
  case ending::grows: return "The swing from side to side grows and continues.";
  case ending::falls: return "The swing from side to side grows until it falls.";
  case ending::other: return "It swings from side to side.";
  }
  return "";
}

bool leave(const ride& r, const std::string& files, const std::string& title) {
  const std::string text = std::string("No one steers. ") + sentence_of(ending_of(r));
  for (const std::string& failure :
       {kanexpr::write_csv(r.trajectory.table(), files + ".csv", {.with_units = false}).cause(),
        write_page_of(r, files + ".html", title, text)}) {
    if (failure.empty()) continue;
    std::fprintf(stderr, "%s\n", failure.c_str());
    return false;
  }
  std::printf("  %s.html and .csv\n", files.c_str());
  return true;
}

bool show_ride(const std::string& folder, const std::string& speed, ending expected) {
  std::printf("\nThe bicycle, pushed to the side with %.1f rad/s at %s m/s\n", push, speed.c_str());
  const auto start = std::chrono::steady_clock::now();
  const ride r = pushed_bicycle(std::stod(speed), push, 10);
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  if (!r) return std::fprintf(stderr, "%s\n", r.cause().c_str()), false;
  std::printf("  simulated %.2f s in %.2f ms: %ld steps, %ld evaluations of all rates\n", r.time,
              taken.count(), r.statistics.steps, r.statistics.rate_evaluations);
  std::printf("  %s\n  It leans %.1f degrees in the first second, %.2f in the last two.\n",
              sentence_of(ending_of(r)), largest_lean(r, 0, 1) / degree,
              largest_lean(r, r.time - 2, r.time) / degree);
  return leave(r, folder + "/bicycle_at_" + speed, "A bicycle pushed at " + speed + " m/s") &&
         ending_of(r) == expected;
}

} // namespace

bool show_rides(const std::string& folder, std::vector<exhibit>& all) {
  const bool dies_out = show_ride(folder, "4.6", ending::dies_out);
  const bool grows = show_ride(folder, "3.5", ending::grows);
  const bool falls = show_ride(folder, "3.0", ending::falls);
  all.push_back(
      {"A bicycle, pushed to the side",
       "No one steers. At 4.6 m/s, the swing dies out; at 3.5 m/s, it grows and continues; at 3.0 m/s, the "
       "bicycle falls.",
       "bicycle.svg",
       {{"At 4.6 m/s", "bicycle_at_4.6.html"},
        {"At 3.5 m/s", "bicycle_at_3.5.html"},
        {"At 3.0 m/s", "bicycle_at_3.0.html"},
        {"Figure", "bicycle.svg"}}});
  all.push_back(
      {"Lean and steer after the push", "The angles over time, at the three speeds.", "push.svg", {}});
  return dies_out && grows && falls;
}

} // namespace demo
