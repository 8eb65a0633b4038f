#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/compiled_pages.hpp>
#include <kanexpr/animate/word_record.hpp>
#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/derivation/survey.hpp>

#include <span>

namespace kanexpr::animate {

/// An interface, independent of the system type, to a motion and to the numbers of its picture.
class scene {
public:
  virtual ~scene() = default;

  const derivation::survey& known;
  std::span<const word_record> words;
  const compiled::code_table& table; ///< evaluates all numbers of the picture
  int numbers, first_rate, rates;    ///< their count, and the range of those that are integrated

  virtual std::size_t samples() const = 0;
  virtual void parameters(double* p) const = 0;
  /// Returns the time, the state and the inputs of a sample.
  virtual void sample(std::size_t which, double& t, double* x, double* r) const = 0;
  /// Returns the state and the inputs at any other time; false if the motion does not provide them.
  virtual bool between(double t, double* x, double* r) const = 0;

protected:
  scene(const derivation::survey& of, std::span<const word_record> shown, const compiled::code_table& code,
        int all, int first, int integrated)
      : known(of), words(shown), table(code), numbers(all), first_rate(first), rates(integrated) {}
};

KANEXPR_PAGES animation film(const scene& shown);

} // namespace kanexpr::animate
