#pragma once

#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/distribution.hpp>
#include <kanexpr/simulate/table.hpp>

#include <kanexpr/describe/symbol_name.hpp>

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

/// What a run is given that is no symbol of the model, as the size of a push: `factor{"push"}`.
struct factor {
  std::string name;
};

/// What differs from run to run: a symbol of the model, its name, or a factor.
class varied_name {
public:
  template <std::convertible_to<symbol_name> Symbol>
  varied_name(const Symbol& symbol) : name_(symbol_name(symbol).name()) {}
  varied_name(factor other) : name_(std::move(other.name)), is_factor_(true) {}

  const std::string& name() const { return name_; }
  bool is_factor() const { return is_factor_; }

private:
  std::string name_;
  bool is_factor_ = false;
};

/// The values that a grid has of something.
struct grid_axis {
  varied_name what;
  std::vector<double> values;
};

/// How something is drawn at random.
struct drawn {
  varied_name what;
  distribution from;
};

/// The runs of a study: how many there are, and what each is given. What a run is given depends on its number
/// alone, so nothing is stored for them but tables.
class runs {
public:
  /// What stands behind it: the values of a run.
  class plan {
  public:
    plan() = default;
    plan(const plan&) = delete;
    plan& operator=(const plan&) = delete;
    virtual ~plan() = default;
    virtual void values(std::size_t run, double* out) const = 0;
  };

  /// One run, in which nothing differs.
  runs() = default;
  runs(std::size_t count, std::vector<varied_name> what, std::shared_ptr<const plan> values,
       std::string text);
  /// None, as they were told wrongly.
  static runs mistaken(std::string mistake);

  std::size_t size() const { return size_; }
  const std::vector<varied_name>& varied() const { return varied_; }
  void values(std::size_t run, double* out) const {
    if (plan_) plan_->values(run, out);
  }
  /// What they are, by which a study is known again.
  const std::string& text() const { return text_; }
  const std::string& mistake() const { return mistake_; }

private:
  std::size_t size_ = 1;
  std::vector<varied_name> varied_{};
  std::shared_ptr<const plan> plan_{};
  std::string text_ = "one run", mistake_{};
};

/// So many numbers from the first to the last, both of which are among them; one alone is the first. None
/// where their number is negative, or beyond 2³².
KANEXPR_ENSEMBLES std::vector<double> evenly_spaced(double first, double last, std::size_t count);

/// Every combination of the values: `grid({{q1, evenly_spaced(-3, 3, 100)}, {m, {1, 2}}})`. The last of the
/// axes changes from each run to the next.
KANEXPR_ENSEMBLES runs grid(std::vector<grid_axis> axes);

/// Independent draws: `random_runs(1000, {{m, normal(1, 0.1)}, {factor{"push"}, uniform(0, 5)}}, 42)`.
KANEXPR_ENSEMBLES runs random_runs(std::size_t count, std::vector<drawn> what, std::uint64_t seed);

/// Draws that are spread: of so many equally probable ranges of each value, every one is drawn from once
/// (McKay, Beckman & Conover, Technometrics 21, 1979).
KANEXPR_ENSEMBLES runs latin_hypercube(std::size_t count, std::vector<drawn> what, std::uint64_t seed);

/// A run of each row of a table; its columns are called as the symbols are, or are factors if they are named
/// as such. Of a table that could not be read there are none, for its cause.
KANEXPR_ENSEMBLES runs runs_of(const table& given, const std::vector<factor>& factors = {});

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/runs.hpp>
#endif
