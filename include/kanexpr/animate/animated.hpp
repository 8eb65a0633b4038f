#pragma once

#include <kanexpr/animate/filming.hpp>
#include <kanexpr/compiled/out_of_line.hpp>

#include <iterator>

namespace kanexpr {

namespace animate {

/// Evaluates a picture along a trajectory.
template <class Picture, class Trajectory>
class camera {
  using numbers = numbers_of<Picture>;
  using System = typename Picture::System;

public:
  explicit camera(const Trajectory& trajectory) : trajectory_(trajectory) {}

  animation film() {
    name_columns();
    const auto count = std::distance(trajectory_.begin(), trajectory_.end());
    if (count == 0) made_.reason = "the trajectory holds no sample";
    film_.numbers.resize(numbers::count, count);
    for (const auto& s : trajectory_)
      if (made_) take(s);
    if (!made_) return std::move(made_);
    integrate();
    develop(made_, records_of<Picture>::list, film_);
    made_.reason = check_numbers(made_);
    return std::move(made_);
  }

private:
  using rates = Eigen::Matrix<double, numbers::rate_count, 1>;

  void name_columns() {
    constexpr const derivation::survey& known = compiled::survey_of<System>;
    for (int i = 0; i < known.coordinates + known.speeds; ++i) {
      std::string name(known.names[i].view());
      if (known.takes_rates_as_speeds && i >= known.coordinates)
        name = std::string(known.names[i - known.coordinates].view()) + '\'';
      made_.columns.push_back({name, {}});
    }
  }

  template <class Sample>
  auto evaluate(const Sample& s) const {
    return out_of_line<function<System, numbers{}>>{}(s.t, s.x, trajectory_.parameters(), s.r);
  }

  template <class Sample>
  void take(const Sample& s) {
    const auto now = evaluate(s);
    const kanexpr::status status = compiled::status_of(now);
    if (!status) made_.reason = std::string(status.cause()) + at_time(s.t);
    if (!s.x.allFinite()) made_.reason = "the state holds what is no number" + at_time(s.t);
    if (!std::isfinite(s.t)) made_.reason = "the time of a sample is no number";
    if (!made_.times.empty() && s.t < made_.times.back())
      made_.reason = "the samples are not in the order of time" + at_time(s.t);
    film_.numbers.col(static_cast<Eigen::Index>(made_.times.size())) = now;
    made_.times.push_back(s.t);
    for (std::size_t i = 0; i < made_.columns.size(); ++i)
      made_.columns[i].values.push_back(s.x(static_cast<Eigen::Index>(i)));
  }

  rates rates_at(Eigen::Index k) const {
    return film_.numbers.col(k).template segment<numbers::rate_count>(numbers::first_rate);
  }

  /// Over a step: by Simpson's rule where the trajectory tells the state halfway, else the trapezoidal rule.
  rates mean_rates(Eigen::Index k) const {
    const rates ends = (rates_at(k) + rates_at(k + 1)) / 2;
    const double before = made_.times[static_cast<std::size_t>(k)];
    const double after = made_.times[static_cast<std::size_t>(k) + 1];
    if constexpr (requires { *trajectory_.at(before); }) {
      if (const auto halfway = trajectory_.at((before + after) / 2); halfway && before < after) {
        const rates there = evaluate(*halfway).template segment<numbers::rate_count>(numbers::first_rate);
        return (ends + 2 * there) / 3;
      }
    }
    return ends;
  }

  void integrate() {
    const Eigen::Index count = film_.numbers.cols();
    film_.integrals.setZero(numbers::rate_count, count);
    if constexpr (numbers::rate_count != 0)
      for (Eigen::Index k = 0; k + 1 < count; ++k) {
        const double step =
            made_.times[static_cast<std::size_t>(k) + 1] - made_.times[static_cast<std::size_t>(k)];
        film_.integrals.col(k + 1) = film_.integrals.col(k) + step * mean_rates(k);
      }
  }

  const Trajectory& trajectory_;
  animation made_{};
  footage film_{};
};

} // namespace animate

/// The shapes of a picture along a trajectory: any range of samples that have a time `t`, a state `x` and
/// inputs `r`, with the `parameters()` of the system.
template <class Picture, class Trajectory>
animation animated(const Trajectory& trajectory) {
  if constexpr (animate::sound_picture<Picture>::value)
    return animate::camera<Picture, Trajectory>(trajectory).film();
  else
    return {};
}

} // namespace kanexpr
