#include "simulations/work_precision.hpp"

int main() {
  work_precision::measure_all<motions::led_pendulum>("a pendulum that a stiff controller leads, 10 s", 3,
                                                     10000);
}
