#pragma once

#include <kanexpr/base/problem.hpp>

#include <exception>

namespace kanexpr::simulated {

/// A function of the user named something that the model does not have. It ends the simulation, not the
/// program.
class misnamed : public std::exception {
public:
  explicit misnamed(const mechanics::problem& why) : why_(why) {}
  const char* what() const noexcept override { return why_.letters; }

private:
  mechanics::problem why_;
};

} // namespace kanexpr::simulated
