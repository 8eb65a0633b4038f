#pragma once

namespace kanexpr {

/// How long the ranks of a study wait for each other.
struct mpi_options {
  /// Seconds after which a run that has not ended is given to another rank too; longer than any run takes.
  double patience = 600;
  /// Seconds without a sign of life, after which a rank is taken for lost. Other ranks wait for the first one
  /// as long as for a run.
  double silence = 60;
};

} // namespace kanexpr
