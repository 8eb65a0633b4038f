#pragma once

namespace kanexpr::robots {

struct reading_options {
  /// Angles that are this near to a multiple of π/2 are that, and directions this near to a basis vector too,
  /// in radians: files write 1.5707 and 3.1416, and the cosines of these are not zero. 0: as they are
  /// written.
  double right_angles = 1e-4;
  /// Whether joints follow others where the file says so; else they move by themselves.
  bool mimic = true;
};

} // namespace kanexpr::robots
