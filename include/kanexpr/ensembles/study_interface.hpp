#pragma once

#include <kanexpr/ensembles/finished_run.hpp>
#include <kanexpr/ensembles/layout.hpp>

#include <cstddef>
#include <vector>

namespace kanexpr::ensembles {

/// A study without the type of its system, as executors, which schedule its runs, see it.
class study_interface {
public:
  study_interface() = default;
  study_interface(const study_interface&) = delete;
  study_interface& operator=(const study_interface&) = delete;
  virtual ~study_interface() = default;

  virtual const study_layout& layout() const = 0;
  /// The number of runs that share a vector; shares of runs start at multiples of it.
  virtual std::size_t lanes() const = 0;
  /// Performs the runs [first, first + count) on the calling thread. The result of a run depends only on its
  /// number.
  virtual std::vector<finished_run> run(std::size_t first, std::size_t count) const = 0;
};

} // namespace kanexpr::ensembles
