#include "compiled.hpp"

#include "../../evaluation/two_threads.hpp"

/// The derivatives of udot_derivatives.cpp for MANY systems, by `many_results` on two threads.
namespace peers {
namespace { // each library has its own

struct derivatives_of_many {
  bench::two_threads threads;
  kanexpr::many<eom::state> x{MANY};
  kanexpr::many<eom::inputs> r{MANY};
  kanexpr::many_results<decltype(linear::explicit_form)> result{MANY};
};

derivatives_of_many& all() {
  static derivatives_of_many those;
  return those;
}

} // namespace
} // namespace peers

extern "C" void udot_derivatives(const double* x, double*) {
  using namespace peers;
  derivatives_of_many& of = all();
  for (int i = 0; i < states; ++i) std::copy_n(x + i * MANY, MANY, of.x(i).data());
  for (int i = 0; i < inputs; ++i) std::copy_n(x + (states + i) * MANY, MANY, of.r(i).data());
  of.result.evaluate(of.threads, of.x, eom::parameters(), of.r);
}

/// What that found, as udot_derivatives.cpp leaves it.
extern "C" void udot_derivatives_found(double* result) {
  using namespace peers;
  constexpr int first = linear::states - (speeds - constraints);
  const auto put = [&](const auto& m) {
    for (int j = 0; j < m.columns; ++j)
      for (int i = first; i < m.rows; ++i) result = std::copy_n(m(i, j).data(), MANY, result);
  };
  put(all().result.result<0>());
  if constexpr (inputs != 0) put(all().result.result<1>());
}
