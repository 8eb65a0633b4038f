#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.hpp>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <memory>
#include <string>
#include <type_traits>

/// Owning handles to SUNDIALS objects, and the error messages of SUNDIALS.
namespace kanexpr::simulations {

struct sundials_deleter {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFree(s); }
};

using vector_handle = std::unique_ptr<std::remove_pointer_t<N_Vector>, sundials_deleter>;
using matrix_handle = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, sundials_deleter>;
using linear_solver_handle = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, sundials_deleter>;
using nonlinear_solver_handle = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, sundials_deleter>;

/// Returns a SUNDIALS vector over numbers that it does not own.
inline vector_handle vector_on(double* numbers, sunindextype size, SUNContext context) {
  return vector_handle(N_VMake_Serial(size, numbers, context));
}

inline vector_handle new_vector(sunindextype size, SUNContext context) {
  return vector_handle(N_VNew_Serial(size, context));
}

inline double* numbers_of(N_Vector v) { return N_VGetArrayPointer(v); }

/// The last error message of SUNDIALS, for use in the message of a failure.
struct last_error {
  std::string message{};

  /// The error handler of all SUNDIALS packages; the default one would print the message.
  static void handle(int, const char*, const char*, char* message, void* receiver) {
    static_cast<last_error*>(receiver)->message = message;
  }
  /// Returns the beginning of a sentence, followed by the message.
  std::string after(const std::string& beginning) const {
    return message.empty() ? beginning : beginning + ": " + message;
  }
};

} // namespace kanexpr::simulations
