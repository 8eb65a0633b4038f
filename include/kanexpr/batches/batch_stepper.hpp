#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batches/input_functions.hpp>
#include <kanexpr/batches/row_arguments.hpp>
#include <kanexpr/compiled/vector_checks.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <type_traits>

namespace kanexpr::batches {

/// An argument of a batch of systems: one value for all of them, or one for each, side by side.
template <class Batch, class Given>
class batch_argument {
public:
  batch_argument(const Given& given, Eigen::Index, Eigen::Index) : given_(given) {}

  const Given& get() const { return given_; }
  void copy_lane(std::size_t, std::size_t) {}

private:
  const Given& given_;
};
template <class Batch, class Vector>
class batch_argument<Batch, many<Vector>> {
public:
  /// Lanes after the last system repeat its values.
  batch_argument(const many<Vector>& all, Eigen::Index first, Eigen::Index last) {
    for (std::size_t lane = 0; lane < Batch::lanes; ++lane)
      Batch::set(values_, lane, all.get((std::min)(first + static_cast<Eigen::Index>(lane), last)));
  }

  auto& get() { return values_; }
  void copy_lane(std::size_t from, std::size_t to) { Batch::set(values_, to, Batch::get(values_, from)); }

private:
  with_scalar<Vector, typename Batch::number> values_{};
};

/// A batch of systems that advances by steps of a fixed length. A system whose step fails leaves the batch,
/// and its lane continues as a copy of another lane.
template <class Step, class Batch, class GivenParameters, class GivenInputs>
class batch_stepper {
  static constexpr std::size_t lanes = Batch::lanes;

public:
  template <class State>
  batch_stepper(const many<State>& x, Eigen::Index first, Eigen::Index count, const GivenParameters& p,
                const GivenInputs& r, double t)
      : t_(t), x_(x, first, first + count - 1), p_(p, first, first + count - 1),
        r_(r, first, first + count - 1) {
    std::fill_n(is_active_.begin(), count, true);
  }

  bool is_active(std::size_t lane) const { return is_active_[lane]; }
  Eigen::Index active_count() const { return std::count(is_active_.begin(), is_active_.end(), true); }
  auto state_in(std::size_t lane) { return Batch::get(x_.get(), lane); }

  /// Advances all systems by one step. Returns false if any of them failed: then leave(lane, why) has been
  /// called for each of these, and the others have not yet taken the step.
  template <class Leave>
  bool step(double h, const Leave& leave) {
    const status all = advance(t_, x_.get(), h, p_.get(), r_.get());
    if (all) return true;
    const Eigen::Index before = active_count();
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (is_active(lane))
        if (const status own = try_single(lane, h); !own) remove(lane, own, leave);
    if (active_count() == before) // the inputs differ from call to call
      for (std::size_t lane = 0; lane < lanes; ++lane)
        if (is_active(lane)) remove(lane, all, leave);
    const auto other = std::find(is_active_.begin(), is_active_.end(), true);
    if (other == is_active_.end()) return false;
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (!is_active(lane)) copy_lane(static_cast<std::size_t>(other - is_active_.begin()), lane);
    return false;
  }

  /// Returns the current value of a function of t, x, p and r in all lanes; r is the inputs or the input
  /// function.
  template <class Function>
  auto evaluate_now(const Function& of) {
    return of(t_, x_.get(), p_.get(), r_.get());
  }

  /// Stores the states of the systems still in the batch, and NaN for the others. Lanes from `count` on hold
  /// no systems.
  template <class State>
  void store_into(many<State>& all, Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (is_active(lane))
        all.set(first + i, state_in(lane));
      else
        all.set_to_nan(first + i, first + i + 1);
    }
  }

private:
  template <class States, class Parameters, class Inputs>
  [[gnu::noinline]] static status advance(double& t, States& x, double h, const Parameters& p,
                                          const Inputs& r) {
    if constexpr (requires { Inputs::SizeAtCompileTime; } || std::is_same_v<Inputs, compiled::omitted> ||
                  accepts_batch<Inputs, States>())
      return Step{}(t, x, h, p, r);
    else
      return Step{}(t, x, h, p, per_lane_inputs<Batch, typename Step::eom::inputs, Inputs>{r});
  }

  /// Tries the step of one system, copied to all lanes; only its status is kept.
  status try_single(std::size_t lane, double h) const {
    batch_stepper single = *this;
    for (std::size_t other = 0; other < lanes; ++other)
      if (other != lane) single.copy_lane(lane, other);
    return advance(single.t_, single.x_.get(), h, single.p_.get(), single.r_.get());
  }

  template <class Leave>
  void remove(std::size_t lane, const status& why, const Leave& leave) {
    leave(lane, why);
    is_active_[lane] = false;
  }

  void copy_lane(std::size_t from, std::size_t to) {
    x_.copy_lane(from, to), p_.copy_lane(from, to), r_.copy_lane(from, to);
  }

  using state = with_scalar<typename Step::eom::state, typename Batch::element>;

  double t_;
  batch_argument<Batch, many<state>> x_;
  batch_argument<Batch, GivenParameters> p_;
  batch_argument<Batch, GivenInputs> r_;
  std::array<bool, lanes> is_active_{};
};

} // namespace kanexpr::batches
