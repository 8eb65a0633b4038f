#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

/// The proofs that a motion of the gallery is right.
namespace gallery {

/// Collects the properties that a motion must have. The page lists those that hold; a property that does not
/// hold stops the page with a sentence.
class checks {
public:
  /// An effect that the motion must show: `expect(last < 0, "the stone reverses its spin")`.
  void expect(bool holds, const std::string& effect) {
    if (holds)
      proofs_.push_back(effect);
    else
      refuse("the motion does not show that " + effect);
  }

  /// A quantity that must keep its first value to within `tolerance` times `size`.
  void expect_constant(const std::string& quantity, const std::vector<double>& values, double size,
                       double tolerance) {
    if (values.empty()) return refuse("the motion has no samples");
    double most = 0;
    for (const double each : values) most = larger(most, std::abs(each - values.front()) / size);
    expect_small(quantity + " stays constant", most, tolerance);
  }

  /// The total energy of a motion without friction or drive, relative to its largest kinetic energy.
  template <class Trajectory>
  void expect_energy(const Trajectory& path, double tolerance) {
    const auto energies = path.energies();
    if (energies.total.empty()) return refuse("the motion has no samples");
    const double most = *std::max_element(energies.kinetic.begin(), energies.kinetic.end());
    expect_constant("the total energy", energies.total, most, tolerance);
  }

  /// The residuals of all constraints, in the units of the constraints.
  template <class Trajectory>
  void expect_constraints(const Trajectory& path, double tolerance) {
    double most = 0;
    for (const double each : path.constraint_residuals()) most = larger(most, std::abs(each));
    expect_small("all constraints hold", most, tolerance);
  }

  /// A property with an error that must be small.
  void expect_small(const std::string& property, double error, double tolerance) {
    if (error <= tolerance)
      proofs_.push_back(property + ", to within " + rounded(error));
    else
      refuse("the motion does not show that " + property + " to within " + rounded(tolerance) +
             "; the error is " + rounded(error));
  }

  /// Stops the page with a sentence; the first one counts.
  void refuse(const std::string& why) {
    if (cause_.empty()) cause_ = why;
  }

  bool holds() const { return cause_.empty(); }
  const std::string& cause() const { return cause_; }
  const std::vector<std::string>& proofs() const { return proofs_; }

  /// A number with a few digits, as in "4.92" and "3.1 × 10⁻⁹".
  static std::string rounded(double number) {
    char text[32];
    if (const double size = std::abs(number); size == 0 || (size >= 1e-3 && size < 1e4)) {
      std::snprintf(text, sizeof text, "%.3g", number);
      return text;
    }
    std::snprintf(text, sizeof text, "%.1e", number);
    const std::string all = text;
    const std::size_t e = all.find('e');
    if (e == std::string::npos) return all; // not a number, or infinite
    static constexpr const char* raised[]{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string exponent = all[e + 1] == '-' ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(std::stoi(all.substr(e + 1)))))
      exponent += raised[digit - '0'];
    return all.substr(0, e) + " × 10" + exponent;
  }

private:
  /// The larger number; if one is not a number, so is the result.
  static double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

  std::vector<std::string> proofs_;
  std::string cause_;
};

} // namespace gallery
