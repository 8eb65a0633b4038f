#pragma once

namespace kanexpr::flexible {

/// How files with standard input data are read.
struct reading_options {
  /// The largest accepted difference between entries of a file that determine each other, such as those of Gr
  /// and of J and Cr, relative to the largest entry of the matrix. Programs round, and lump masses
  /// differently for different matrices; errors in signs or in the order of entries are far larger.
  double agreement = 1e-2;
  /// Whether larger differences are only noted. Then the mass, mdCM, J, Ct, Cr, Me, Ke and De, and the
  /// symmetric parts of Oe and Ct, define the body.
  bool prefer_derived = false;
};

} // namespace kanexpr::flexible
