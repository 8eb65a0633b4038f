#include "simulations/work_precision.hpp"

#include <models/andrews.hpp>
#include <systems/andrews_reference.hpp>

namespace {

using namespace kanexpr;

/// Andrews' squeezing mechanism: closed loops, and fast.
struct squeezer {
  using System = andrews::System;
  static constexpr time_span span{0, 0.03};

  static state<System> start(double) {
    state<System> x;
    x.q() = andrews_reference::start;
    return x;
  }
  static parameter_values<System> parameters() { return {}; }
  static void give_inputs(double, const state<System>&, input_values<System>&) {}
};

} // namespace

int main() { work_precision::measure_all<squeezer>("Andrews' squeezing mechanism, 30 ms", 1, 1000); }
