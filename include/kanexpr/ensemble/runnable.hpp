#pragma once

#include <kanexpr/ensemble/on_threads.hpp>

#include <memory>
#include <utility>

namespace kanexpr::ensembles {

/// A study of whatever kind as its user has it run. Copies share it.
template <class Study>
class runnable {
public:
  ensemble_results run(const ensemble_options& options = {}) const {
    on_threads threads;
    return run(options, threads);
  }
  /// The same by others than threads of this process, as the ranks of <kanexpr/mpi.hpp>.
  ensemble_results run(const ensemble_options& options, crew& who) const {
    if (study_->mistake().empty()) return who.run(*study_, study_->text(), options);
    ensemble_results none;
    none.planned = layout().runs;
    none.failure = study_->mistake();
    return none;
  }

  const study_layout& layout() const { return study_->layout(); }

protected:
  template <class... Told>
  explicit runnable(std::in_place_t, Told&&... told)
      : study_(std::make_shared<Study>(std::forward<Told>(told)...)) {
    study_->itself = study_;
  }

  runnable(const runnable&) = default;
  runnable(runnable&&) = default;
  runnable& operator=(const runnable&) = default;
  runnable& operator=(runnable&&) = default;
  ~runnable() = default;

private:
  std::shared_ptr<const Study> study_;
};

} // namespace kanexpr::ensembles
