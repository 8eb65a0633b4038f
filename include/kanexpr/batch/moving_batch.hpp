#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batch/inputs_by_law.hpp>
#include <kanexpr/batch/side_by_side.hpp>
#include <kanexpr/compiled/fitting.hpp>

#include <algorithm>
#include <array>

namespace kanexpr::batches {

/// An argument of a batch of systems: one value for all of them, or one for each, side by side.
template <class Batch, class Given>
class given_to_batch {
public:
  given_to_batch(const Given& given, Eigen::Index, Eigen::Index) : given_(given) {}

  const Given& get() const { return given_; }
  void copy_lane(std::size_t, std::size_t) {}

private:
  const Given& given_;
};
template <class Batch, class Vector>
class given_to_batch<Batch, many<Vector>> {
public:
  /// Lanes after the last system repeat its values.
  given_to_batch(const many<Vector>& all, Eigen::Index first, Eigen::Index last) {
    for (std::size_t lane = 0; lane < Batch::lanes; ++lane)
      Batch::set(values_, lane, all.get((std::min)(first + static_cast<Eigen::Index>(lane), last)));
  }

  auto& get() { return values_; }
  void copy_lane(std::size_t from, std::size_t to) { Batch::set(values_, to, Batch::get(values_, from)); }

private:
  with_scalar<Vector, typename Batch::number> values_{};
};

/// A batch of systems that advances by steps of a fixed length. A system whose step fails leaves the batch,
/// and its lane continues as a copy of another.
template <class Step, class Batch, class GivenParameters, class GivenInputs>
class moving_batch {
  static constexpr std::size_t lanes = Batch::lanes;

public:
  template <class State>
  moving_batch(const many<State>& x, Eigen::Index first, Eigen::Index count, const GivenParameters& p,
               const GivenInputs& r, double t)
      : t_(t), x_(x, first, first + count - 1), p_(p, first, first + count - 1),
        r_(r, first, first + count - 1) {
    std::fill_n(lives_.begin(), count, true);
  }

  bool lives(std::size_t lane) const { return lives_[lane]; }
  Eigen::Index living() const { return std::count(lives_.begin(), lives_.end(), true); }
  auto state_in(std::size_t lane) { return Batch::get(x_.get(), lane); }

  /// Advances all systems by one step. Returns false if any of them failed: then leave(lane, why) has been
  /// called for each of these, and the others have not yet taken the step.
  template <class Leave>
  bool step(double h, const Leave& leave) {
    const status all = made(t_, x_.get(), h, p_.get(), r_.get());
    if (all) return true;
    const Eigen::Index before = living();
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (lives(lane))
        if (const status own = try_alone(lane, h); !own) remove(lane, own, leave);
    if (living() == before) // the inputs differ from call to call
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if (lives(lane)) remove(lane, all, leave);
    const auto other = std::find(lives_.begin(), lives_.end(), true);
    if (other == lives_.end()) return false;
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (!lives(lane)) copy_lane(static_cast<std::size_t>(other - lives_.begin()), lane);
    return false;
  }

  /// Returns the current value of a function of t, x, p and r in all lanes; r is the inputs or the input
  /// function.
  template <class Function>
  auto at_present(const Function& of) {
    return of(t_, x_.get(), p_.get(), r_.get());
  }

  /// Stores the states of the systems still in the batch, and NaN for the others. Lanes from `count` on hold
  /// no systems.
  template <class State>
  void put_into(many<State>& all, Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (lives(lane))
        all.set(first + i, state_in(lane));
      else
        all.leave_no_numbers(first + i, first + i + 1);
    }
  }

private:
  template <class States, class Parameters, class Inputs>
  [[gnu::noinline]] static status made(double& t, States& x, double h, const Parameters& p, const Inputs& r) {
    if constexpr (requires { Inputs::SizeAtCompileTime; } || std::is_same_v<Inputs, compiled::not_given> ||
                  takes_batches<Inputs, States>())
      return Step{}(t, x, h, p, r);
    else
      return Step{}(t, x, h, p, lane_by_lane<Batch, typename Step::eom::inputs, Inputs>{r});
  }

  /// Tries the step of one system, copied to all lanes; only its status is kept.
  status try_alone(std::size_t lane, double h) const {
    moving_batch alone = *this;
    for (std::size_t other = 0; other < lanes; ++other)
      if (other != lane) alone.copy_lane(lane, other);
    return made(alone.t_, alone.x_.get(), h, alone.p_.get(), alone.r_.get());
  }

  template <class Leave>
  void remove(std::size_t lane, const status& why, const Leave& leave) {
    leave(lane, why);
    lives_[lane] = false;
  }

  void copy_lane(std::size_t from, std::size_t to) {
    x_.copy_lane(from, to), p_.copy_lane(from, to), r_.copy_lane(from, to);
  }

  using state = with_scalar<typename Step::eom::state, typename Batch::element>;

  double t_;
  given_to_batch<Batch, many<state>> x_;
  given_to_batch<Batch, GivenParameters> p_;
  given_to_batch<Batch, GivenInputs> r_;
  std::array<bool, lanes> lives_{};
};

} // namespace kanexpr::batches
