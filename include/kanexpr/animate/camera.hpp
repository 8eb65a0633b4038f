#pragma once

#include <kanexpr/animate/filming.hpp>
#include <kanexpr/animate/scene.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace kanexpr::animate {

/// Evaluates a picture along a motion.
class camera {
public:
  explicit camera(const scene& shown)
      : scene_(shown), numbers_(shown.table, shown.known),
        x_(static_cast<std::size_t>(shown.known.coordinates + shown.known.speeds)),
        p_(static_cast<std::size_t>(shown.known.parameters)),
        r_(static_cast<std::size_t>(shown.known.inputs)) {
    scene_.parameters(p_.data());
  }

  animation film() {
    name_columns();
    if (scene_.samples() == 0) made_.failure = "the trajectory has no samples";
    film_.numbers.resize(scene_.numbers, static_cast<Eigen::Index>(scene_.samples()));
    for (std::size_t i = 0; i < scene_.samples() && made_; ++i) take(i);
    if (!made_) return std::move(made_);
    integrate();
    develop(made_, scene_.words, film_);
    made_.failure = check_numbers(made_);
    return std::move(made_);
  }

private:
  void name_columns() {
    const derivation::survey& known = scene_.known;
    for (int i = 0; i < known.coordinates + known.speeds; ++i) {
      std::string name(known.names[i].view());
      if (known.takes_rates_as_speeds && i >= known.coordinates)
        name = std::string(known.names[i - known.coordinates].view()) + '\'';
      made_.columns.push_back({name, {}});
    }
  }

  void take(std::size_t sample) {
    double t = 0;
    scene_.sample(sample, t, x_.data(), r_.data());
    const status s = evaluate(t, column(film_.numbers, sample));
    if (!s) made_.failure = s.cause() + at_time(t);
    for (const double entry : x_)
      if (!numeric::is_finite(entry)) made_.failure = "the state is not finite" + at_time(t);
    if (!numeric::is_finite(t)) made_.failure = "the time of a sample is not finite";
    if (!made_.times.empty() && t < made_.times.back())
      made_.failure = "the times of the samples decrease" + at_time(t);
    made_.times.push_back(t);
    for (std::size_t i = 0; i < made_.columns.size(); ++i) made_.columns[i].values.push_back(x_[i]);
  }

  status evaluate(double t, double* all) {
    return numbers_.evaluate(t, x_.data(), p_.data(), r_.data(), all);
  }
  bool take_between(double t, double* all) {
    if (!scene_.between(t, x_.data(), r_.data())) return false;
    evaluate(t, all);
    return true;
  }

  static double* column(Eigen::MatrixXd& m, std::size_t k) {
    return m.data() + static_cast<Eigen::Index>(k) * m.rows();
  }

  /// Integrates over each step by Simpson's rule if the trajectory provides the state at the midpoint, else
  /// by the trapezoidal rule.
  void integrate() {
    const std::size_t count = made_.times.size();
    film_.integrals.setZero(scene_.rates, static_cast<Eigen::Index>(count));
    if (scene_.rates == 0) return;
    std::vector<double> halfway(static_cast<std::size_t>(scene_.numbers));
    for (std::size_t k = 0; k + 1 < count; ++k) {
      const double before = made_.times[k], after = made_.times[k + 1];
      const bool is_between = before < after && take_between((before + after) / 2, halfway.data());
      const double *here = column(film_.numbers, k) + scene_.first_rate, *there = here + scene_.numbers;
      const double* between = halfway.data() + scene_.first_rate;
      const double* was = column(film_.integrals, k);
      double* becomes = column(film_.integrals, k + 1);
      for (int i = 0; i < scene_.rates; ++i) {
        const double ends = (here[i] + there[i]) / 2;
        becomes[i] = was[i] + (after - before) * (is_between ? (ends + 2 * between[i]) / 3 : ends);
      }
    }
  }

  const scene& scene_;
  runtime::table_interpreter<double> numbers_;
  std::vector<double> x_, p_, r_;
  animation made_{};
  footage film_{};
};

KANEXPR_PAGES animation film(const scene& shown) { return camera(shown).film(); }

} // namespace kanexpr::animate
