#pragma once

namespace kanexpr::robots {

struct reading_options {
  /// The tolerance in radians within which angles are rounded to multiples of π/4 and directions to basis
  /// vectors: files contain numbers such as 1.5707 and 3.1416, whose cosine or sine is not exactly zero. 0
  /// keeps angles as written.
  double right_angles = 1e-4;
  /// Whether mimic joints follow their leaders; if not, they move independently.
  bool mimic = true;
};

} // namespace kanexpr::robots
