#pragma once

namespace kanexpr::symbolic {

/// What the operations of a function cost on a target, in any unit. The default suits processors with a
/// floating-point unit. A processor that evaluates a product and the sum that uses it as one operation gives
/// `fused` the cost of a multiplication; without a unit for `double`, a division costs about four
/// multiplications and a sine about thirty.
struct operation_weights {
  int multiplication = 1;
  int addition = 1;
  /// A sum and one product that only this sum uses, together.
  int fused = multiplication + addition;
  int division = 4;
  int square_root = 6;
  int trigonometric = 16; ///< the sine and the cosine of one angle, or another trigonometric function
  int other = 20;         ///< any other function

  constexpr bool operator==(const operation_weights&) const = default;

  /// Whether fused products have to be counted.
  constexpr bool depends_on_fusing() const { return fused != 1LL * multiplication + addition; }

  constexpr bool is_negative_for_any() const {
    return multiplication < 0 || addition < 0 || fused < 0 || division < 0 || square_root < 0 ||
           trigonometric < 0 || other < 0;
  }
};

/// The operations of `operation_weights` by name.
struct weighted_operation {
  const char* called;
  int operation_weights::* weight;
};
inline constexpr weighted_operation weighted_operations[] = {
    {"multiplication", &operation_weights::multiplication},
    {"addition", &operation_weights::addition},
    {"fused", &operation_weights::fused},
    {"division", &operation_weights::division},
    {"square_root", &operation_weights::square_root},
    {"trigonometric", &operation_weights::trigonometric},
    {"other", &operation_weights::other},
};

} // namespace kanexpr::symbolic
