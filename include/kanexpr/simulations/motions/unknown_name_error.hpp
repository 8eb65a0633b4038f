#pragma once

#include <kanexpr/base/sentence.hpp>

#include <exception>

namespace kanexpr::simulations {

/// Thrown when a user function uses a name that the model does not have. It ends the simulation, not the
/// program.
class unknown_name_error : public std::exception {
public:
  explicit unknown_name_error(const base::sentence& why) : why_(why) {}
  const char* what() const noexcept override { return why_.letters; }

private:
  base::sentence why_;
};

} // namespace kanexpr::simulations
