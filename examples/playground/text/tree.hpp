#pragma once

#include <string>
#include <vector>

namespace playground {

/// An expression as it is written: the operands of an operation are its parts.
struct tree {
  enum class kind : unsigned char {
    number,
    name,
    axis, ///< `A.x`: `text` is the frame, `axis` the letter
    call, ///< `text` is the function
    negative,
    sum,
    difference,
    product,
    quotient,
    power
  };

  kind is = kind::number;
  double value = 0;
  char axis = 'x';
  std::string text{};
  std::vector<tree> parts{};
};

} // namespace playground
