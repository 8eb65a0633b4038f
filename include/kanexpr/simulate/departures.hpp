#pragma once

#include <kanexpr/simulate/surroundings.hpp>

#include <vector>

namespace kanexpr::simulated {

/// Tells where events follow one another too fast for numbers, as the bounces of a ball do in the end: a
/// function that a handler turned round is found beyond zero and no event was seen, or passes zero in one
/// direction while its rate has the other.
template <class System>
class departures {
public:
  using state = kanexpr::state<System>;

  /// Whether functions pass zero against their rates.
  bool contradict(double t, const state& x, const std::vector<int>& passed, surroundings<System>& around) {
    const std::vector<int> signs = signs_of_rates(t, x, passed.size(), around);
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (signs[i] * passed[i] < 0) return true;
    return false;
  }

  /// Notes to which side those go that have just passed zero, from the state in which the handlers left them.
  void note(double t, const state& x, const std::vector<int>& passed, surroundings<System>& around) {
    sides_ = signs_of_rates(t, x, passed.size(), around);
    for (std::size_t i = 0; i < passed.size(); ++i)
      if (sides_[i] * passed[i] >= 0) sides_[i] = 0;
  }

  /// Whether one is back beyond where it was noted, and was not seen to return.
  bool missed(double t, const state& x, const std::vector<int>& passed, surroundings<System>& around) {
    if (sides_.empty()) return false;
    bool found = false;
    std::vector<double> now(sides_.size());
    if (around.watch(t, x.data(), now.data()) == answer::given)
      for (std::size_t i = 0; i < sides_.size(); ++i)
        found |= sides_[i] * now[i] < 0 && sides_[i] * (now[i] - here_[i]) < 0 && passed[i] == 0;
    sides_.clear();
    return found;
  }

private:
  /// Of each watched function: 1 where it rises, 0 where that cannot be told.
  std::vector<int> signs_of_rates(double t, const state& x, std::size_t count, surroundings<System>& around) {
    std::vector<int> signs(count);
    here_.resize(count), later_.resize(count);
    if (around.watch(t, x.data(), here_.data()) != answer::given) return signs;
    const state ahead = state(x + instant * equations_of_motion<System>::rhs(t, x, around.p(), around.r()));
    if (around.watch(t + instant, ahead.data(), later_.data()) == answer::given)
      for (std::size_t i = 0; i < count; ++i) signs[i] = (later_[i] > here_[i]) - (later_[i] < here_[i]);
    return signs;
  }

  static constexpr double instant = 1e-6; // the rates are held meanwhile: only the sign of a change counts

  std::vector<int> sides_;
  std::vector<double> here_, later_;
};

} // namespace kanexpr::simulated
