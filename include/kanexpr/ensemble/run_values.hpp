#pragma once

#include <kanexpr/ensemble/runs.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace kanexpr {

namespace ensembles {

/// Something is asked for that does not differ from run to run.
struct no_such_value : std::out_of_range {
  using std::out_of_range::out_of_range;
};

} // namespace ensembles

/// What a run of a study is given: `values["push"]`, `values[m]`.
class run_values {
public:
  run_values(const runs& of, std::size_t run) : varied_(of.varied()), run_(run), values_(varied_.size()) {
    of.values(run, values_.data());
  }

  std::size_t run() const { return run_; } ///< its number, from 0
  const std::vector<double>& all() const { return values_; }

  /// Throws a std::out_of_range where that does not differ from run to run.
  double operator[](const varied_name& what) const {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (varied_[i].name() == what.name()) return values_[i];
    throw ensembles::no_such_value("the runs of the study have no " + what.name() + " that differs");
  }

private:
  const std::vector<varied_name>& varied_;
  std::size_t run_;
  std::vector<double> values_;
};

namespace ensembles {

/// What a function asks for that no run is given; what else it throws is the affair of its run.
template <class Function>
std::string mistake_in_call(const Function& of) {
  std::string mistake;
  try {
    of();
  } catch (const no_such_value& asked) {
    mistake = asked.what();
  } catch (...) {
    mistake.clear();
  }
  return mistake;
}

} // namespace ensembles

} // namespace kanexpr
