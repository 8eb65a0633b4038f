#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/runtime/derived.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <memory>
#include <string>
#include <vector>

#include <kanexpr/base/letters_aside.hpp>

namespace kanexpr {

class linearization_point;

namespace runtime {

/// M δ[q̇; u̇; λ] = A δ[q_i; u_i] + B δr.
struct implicit_matrices {
  symbolic::matrix M, A, B{};
};

/// δ[q̇_i; u̇_i] = A δ[q_i; u_i] + B δr.
struct explicit_matrices {
  symbolic::matrix A, B{};
};

/// δy = C δ[q_i; u_i] + D δr for outputs y.
struct output_matrices {
  symbolic::matrix C, D;
};

/// A system linearized about an operating point at run time, as matrices of expressions. Symbols that the
/// point does not name are kept. Each result is formed when it is first requested. Copies share the results.
class linearization {
public:
  /// If the system has a mistake, there are no results, and the mistake is the only failure.
  linearization(std::shared_ptr<derived> system, const linearization_point& at);

  /// Whether the point satisfies all equations and all results requested so far have values there.
  explicit operator bool() const { return failures().empty(); }

  /// Sentences that describe the mistakes in the point and the entries that have no value there.
  const std::vector<std::string>& failures() const;

  const implicit_matrices& implicit_form();
  const explicit_matrices& explicit_form();

  /// Linearizes outputs that contain q, u, r and their rates.
  output_matrices outputs(const symbolic::matrix& y);

  /// P in [q; u; λ] = P [q_i; u_i; q_d; u_d; λ].
  symbolic::matrix permutation();

  /// The names of the states and of the inputs, in the order of the matrices.
  std::vector<std::string> states();
  std::vector<std::string> inputs();

private:
  class at_point;
  std::shared_ptr<at_point> at_;
};

} // namespace runtime

} // namespace kanexpr

#include <kanexpr/base/letters_back.hpp>

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/linearization.ipp>
#endif
