#pragma once

#include <kanexpr/describe/symbol_name.hpp>
#include <kanexpr/ensembles/compiled_ensembles.hpp>
#include <kanexpr/ensembles/distribution.hpp>
#include <kanexpr/simulations/tables/table.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

/// A varied quantity that is not a symbol of the model, such as the size of a push: `factor{"push"}`.
struct factor {
  std::string name;
};

/// The name of a varied quantity: a symbol of the model, its name, or a factor.
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

/// The values of a quantity in a grid.
struct grid_axis {
  varied_name what;
  std::vector<double> values;
};

/// A quantity and its distribution.
struct drawn {
  varied_name what;
  distribution from;
};

/// The runs of a study: their number, and the varied values of each. The values depend only on the number of
/// the run, so only tables are stored.
class runs {
public:
  /// Computes the values of a run.
  using plan = std::function<void(std::size_t run, double* values)>;

  /// A single run, in which nothing varies.
  runs() = default;
  runs(std::size_t count, std::vector<varied_name> what, plan values, std::string identity);
  /// Returns an invalid set of runs, with the reason.
  static runs mistaken(std::string mistake);

  std::size_t size() const { return size_; }
  const std::vector<varied_name>& varied() const { return varied_; }
  bool varies(const std::string& name) const {
    return std::ranges::find(varied_, name, &varied_name::name) != varied_.end();
  }
  void values(std::size_t run, double* out) const {
    if (plan_) plan_(run, out);
  }
  /// Distinguishes these runs from others.
  const std::string& identity() const { return identity_; }
  const std::string& mistake() const { return mistake_; }

private:
  std::size_t size_ = 1;
  std::vector<varied_name> varied_{};
  plan plan_{};
  std::string identity_ = "one run", mistake_{};
};

namespace ensembles {

/// Thrown for a value that does not vary.
struct no_such_value : std::out_of_range {
  using std::out_of_range::out_of_range;
};

} // namespace ensembles

/// The varied values of a run: `values["push"]`, `values[m]`.
class run_values {
public:
  run_values(const runs& of, std::size_t run) : varied_(of.varied()), run_(run), values_(varied_.size()) {
    of.values(run, values_.data());
  }

  std::size_t run() const { return run_; } ///< its number, from 0
  const std::vector<double>& all() const { return values_; }

  /// Throws a std::out_of_range if the value does not vary.
  double operator[](const varied_name& what) const {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (varied_[i].name() == what.name()) return values_[i];
    throw ensembles::no_such_value("the runs of the study do not vary " + what.name());
  }

private:
  const std::vector<varied_name>& varied_;
  std::size_t run_;
  std::vector<double> values_;
};

namespace ensembles {

/// Returns a message if a function of the study requests a value that does not vary. Other exceptions concern
/// a single run and are ignored here.
template <class Function>
std::string mistake_in_call(const Function& of) {
  std::string mistake;
  try {
    of();
  } catch (const no_such_value& requested) {
    mistake = requested.what();
  } catch (...) {
    mistake.clear();
  }
  return mistake;
}

} // namespace ensembles

/// Returns `count` equally spaced numbers from the first to the last, inclusive; empty if the count is
/// negative or exceeds 2³².
KANEXPR_ENSEMBLES std::vector<double> evenly_spaced(double first, double last, std::size_t count);

/// All combinations: `grid({{q1, evenly_spaced(-3, 3, 100)}, {m, {1, 2}}})`. The last axis varies fastest.
KANEXPR_ENSEMBLES runs grid(std::vector<grid_axis> axes);

/// Independent draws: `random_runs(1000, {{m, normal(1, 0.1)}, {factor{"push"}, uniform(0, 5)}}, 42)`.
KANEXPR_ENSEMBLES runs random_runs(std::size_t count, std::vector<drawn> what, std::uint64_t seed);

/// A Latin hypercube: each quantity has one draw from each of `count` equally probable intervals (McKay,
/// Beckman & Conover, Technometrics 21, 1979).
KANEXPR_ENSEMBLES runs latin_hypercube(std::size_t count, std::vector<drawn> what, std::uint64_t seed);

/// One run per row of a table. Each column has the name of a symbol or of a listed factor.
KANEXPR_ENSEMBLES runs runs_of(const table& rows, const std::vector<factor>& factors = {});

} // namespace kanexpr

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensembles/runs.ipp>
#endif
