// The error of sine and cosine for a given number of angles, compared with libquadmath's functions with 113
// bits, and for all numbers of type `float` up to the farthest angle.
#include <kanexpr/numeric/sine_and_cosine.hpp>

#include <CLI/CLI.hpp>

#include <quadmath.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace {

/// The largest error and the angle at which it occurs.
struct worst {
  double ulps = 0, angle = 0;

  template <class T>
  void look_at(T found, __float128 exact, T at) {
    const int exponent =
        std::max(std::ilogb(static_cast<T>(exact)), std::numeric_limits<T>::min_exponent - 1);
    const auto error = static_cast<double>(scalbnq(fabsq(static_cast<__float128>(found) - exact),
                                                   std::numeric_limits<T>::digits - 1 - exponent));
    if (!(error <= ulps)) ulps = error, angle = static_cast<double>(at);
  }
};

struct errors {
  worst sine, cosine;
  long angles = 0;

  template <class T>
  void look_at(T angle) {
    T s, c;
    kanexpr::numeric::sine_and_cosine(angle, s, c);
    __float128 exact_sine, exact_cosine;
    if constexpr (sizeof(T) == 4) {
      exact_sine = std::sin(static_cast<long double>(angle));
      exact_cosine = std::cos(static_cast<long double>(angle));
    } else {
      sincosq(static_cast<__float128>(angle), &exact_sine, &exact_cosine);
    }
    sine.look_at(s, exact_sine, angle);
    cosine.look_at(c, exact_cosine, angle);
    ++angles;
  }

  void print(const char* type) const {
    std::printf("%s: %ld angles, worst errors: sine %.4f ulp at %a, cosine %.4f ulp at %a\n", type, angles,
                sine.ulps, sine.angle, cosine.ulps, cosine.angle);
  }
  bool are_small() const { return sine.ulps <= 1.5 && cosine.ulps <= 1.5; }
};

/// Angles next to multiples of pi/4, where the offset is smallest or largest.
void look_beside_multiples(errors& all) {
  for (int k = 1; k * 0.7853981633974483 < kanexpr::numeric::farthest_angle; ++k) {
    const double angle = k * 0.7853981633974483, above = std::nextafter(angle, 1e9),
                 below = std::nextafter(angle, 0);
    for (double each : {angle, above, below, std::nextafter(above, 1e9), std::nextafter(below, 0)})
      all.look_at(each);
  }
}

void look_at_random(errors& all, long count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> near(-3.2, 3.2),
      any(-kanexpr::numeric::farthest_angle, kanexpr::numeric::farthest_angle), exponent(-43, 17);
  for (long i = 0; i < count; i += 3) {
    all.look_at(near(engine));
    all.look_at(any(engine));
    all.look_at(std::exp2(exponent(engine)));
  }
}

void look_at_floats(errors& all, unsigned step) {
  const auto last = std::bit_cast<unsigned>(static_cast<float>(kanexpr::numeric::farthest_angle));
  for (unsigned bits = 0; bits <= last; bits += step) all.look_at(std::bit_cast<float>(bits));
}

} // namespace

int main(int count, char** words) {
  long angles = 1'000'000'000;
  unsigned step = 1;
  CLI::App line("Measures the error of sine and cosine, and fails where it exceeds 1.5 ulp");
  line.add_option("--angles", angles, "How many random angles in double precision");
  line.add_option("--step", step, "Each how manieth float")->check(CLI::PositiveNumber);
  CLI11_PARSE(line, count, words);
  errors of_double, of_float;
  look_beside_multiples(of_double);
  look_at_random(of_double, angles);
  of_double.print("double");
  look_at_floats(of_float, step);
  of_float.print("float");
  return of_double.are_small() && of_float.are_small() ? 0 : 1;
}
