// A study whose model is in a shared library, which may be replaced by a different one: `study CHECKPOINT
// RUNS` ends after this many runs; 0: when all are done.
#include "model.hpp"

#include <kanexpr/ensemble.hpp>

#include <cstdio>
#include <cstdlib>

int main(int, char** arguments) {
  using namespace exchanged;
  const double most = std::atof(arguments[2]);
  std::stop_source stop;
  const auto found = ensemble<exchanged::System>({.runs = grid({{q, evenly_spaced(-3, 3, 200)}}),
                                                  .state = {{u, 0}},
                                                  .parameters = {{m, 1}, {l, 1}, {g, 9.81}, {c, 0.1}},
                                                  .span = {0, 3},
                                                  .keep = {at_end<q>()}})
                         .run({.threads = 1,
                               .checkpoint = arguments[1],
                               .progress =
                                   [&](double done, double, double) {
                                     if (most > 0 && done >= most) stop.request_stop();
                                   },
                               .stop = stop.get_token()});
  std::printf("%s\n", found ? "complete" : found.cause().c_str());
}
