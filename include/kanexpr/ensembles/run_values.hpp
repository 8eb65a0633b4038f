#pragma once

#include <kanexpr/ensembles/runs.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace kanexpr {

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

/// Reports a value that a function of the study requests and that does not vary; other exceptions concern one
/// run.
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

} // namespace kanexpr
