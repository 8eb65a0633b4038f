#include "simulations/work_precision.hpp"

int main() {
  work_precision::measure_all<motions::double_pendulum>("a chaotic double pendulum, 10 s", 10, 2000);
}
