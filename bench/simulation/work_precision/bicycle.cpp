#include "simulations/work_precision.hpp"

int main() { work_precision::measure_all<motions::bicycle>("the bicycle after a push, 10 s", 5, 2000); }
