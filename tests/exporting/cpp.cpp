// The C++ headers, compiled as C++11: the results of the C functions, with names.
#include <bead_in_float.hpp>
#include <four_bar.hpp>
#include <pendulum.hpp>

#include <cmath>
#include <cstdio>
#include <cstring>

static int failures = 0;

static void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what);
  ++failures;
}

int main() {
#include <docs/export/c/names.cpp>
  const double in_c[] = {0.3, 0}, p_in_c[] = {2, 0.5, 0.1}, r_in_c[] = {0.2};
  double rate[1];
  pendulum_udot(0, in_c, p_in_c, r_in_c, rate);
  expect(static_cast<bool>(found.made) && found.made.cause[0] == '\0', "a good status");
  expect(std::memcmp(found.udot, rate, sizeof rate) == 0, "the bits of the function of C");
  expect(std::isnan(pendulum::udot(x, pendulum::parameters(), r).udot[0]),
         "parameters are not numbers until they are set");

  four_bar::parameters bars;
  double lengths[four_bar_parameters];
  for (double& each : lengths) each = 1;
  bars = four_bar::parameters::from(lengths);
  const four_bar::inputs none = four_bar::inputs::from(lengths);
  const four_bar::udot_result along_a_line = four_bar::udot(four_bar::state(), bars, none);
  expect(!along_a_line.made && std::strcmp(along_a_line.made.cause, four_bar_udot_causes[0]) == 0,
         "the sentence of a status");
  const four_bar::explicit_form_result form = four_bar::explicit_form(four_bar::state(), bars, none);
  expect(sizeof form.A == 4 * sizeof(double) && sizeof form.A[0] == 2 * sizeof(double), "matrices by rows");

  bead_in_float::state s;
  s.s = 1;
  bead_in_float::parameters with;
  with.m = 1, with.w = 0, with.g = 0;
  bead_in_float::inputs push;
  push.push = 2;
  const bead_in_float::runge_kutta_4_result next = bead_in_float::runge_kutta_4(s, 0.5F, with, push);
  expect(next.made && std::fabs(next.next.s - 1.25F) < 1e-6F && std::fabs(next.next.v - 1.0F) < 1e-6F,
         "a step");
  return failures;
}
