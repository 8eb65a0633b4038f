#pragma once

#include <kanexpr/ensemble/finished_run.hpp>
#include <kanexpr/ensemble/layout.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace kanexpr::ensembles {

/// A study as those see it who share out its runs: they know no model.
class job {
public:
  job() = default;
  job(const job&) = delete;
  job& operator=(const job&) = delete;
  virtual ~job() = default;

  virtual const study_layout& layout() const = 0;
  /// How many runs, at a multiple of this number, are done side by side.
  virtual std::size_t side_by_side() const = 0;
  /// Does the runs [first, first + count), on any thread: what a run leaves depends on its number alone.
  virtual std::vector<finished_run> run(std::size_t first, std::size_t count) const = 0;

  /// Where it is shared, for threads that are left behind.
  mutable std::weak_ptr<const job> itself{};
};

} // namespace kanexpr::ensembles
