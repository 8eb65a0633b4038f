#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/compiled_pages.hpp>
#include <kanexpr/animate/word_record.hpp>
#include <kanexpr/base/status.hpp>

#include <span>

namespace kanexpr::animate {

/// A motion and the numbers of its picture, as far as they do not depend on the system.
class scene {
public:
  virtual ~scene() = default;

  const deriving::survey& known;
  std::span<const word_record> words;
  int numbers, first_rate, rates; ///< all numbers of the picture, and which of them are integrated

  virtual std::size_t samples() const = 0;
  /// The time and the state of a sample, and the numbers there.
  virtual status take(std::size_t sample, double& t, double* x, double* all) const = 0;
  /// The numbers at another time; false where the motion does not tell.
  virtual bool take_between(double t, double* all) const = 0;

protected:
  scene(const deriving::survey& of, std::span<const word_record> shown, int all, int first, int integrated)
      : known(of), words(shown), numbers(all), first_rate(first), rates(integrated) {}
};

KANEXPR_PAGES animation film(const scene& shown);

} // namespace kanexpr::animate
