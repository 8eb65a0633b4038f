#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

/// The contents of a file with standard input data, as written.
namespace kanexpr::flexible::sid {

/// One number of a Taylor series: m0(row, column), m1 with three indices or m2 with four, all counted from 1.
struct entry {
  int first = 0, second = 0, third = 0, fourth = 0;
  double value = 0;
  int line = 0;
};

/// How the entries of a matrix are stored.
enum class structure : int { zero, diagonal, symmetric, full, unit };

/// A matrix as a series in the amplitudes: M(q) = m0 + Σ_k m1_k q_k + Σ_kl m2_kl q_k q_l.
struct series {
  std::string_view called{};
  int line = 0; ///< 0 if the file does not contain it
  int order = 0, rows = 0, columns = 0, amplitudes = 0;
  sid::structure structure = sid::structure::full;
  std::vector<entry> m0{}, m1{}, m2{};

  bool is_given() const { return line != 0; }
  /// The line of the first term of second order that is not zero; 0 if there is none.
  int line_of_second_order() const {
    for (const entry& e : m2)
      if (std::abs(e.value) > 0) return e.line;
    return 0;
  }
};

struct node {
  std::string called{};
  int line = 0;
  series origin{"origin"}, phi{"phi"}, psi{"psi"}, orientation{"AP"};
};

/// The matrices of a body, in the order in which they are usually written.
enum class matrix : int { mdcm, j, ct, cr, me, gr, ge, oe, ksigma, ke, de };
inline constexpr std::array<std::string_view, 11> matrix_names{"mdCM", "J",  "Ct",     "Cr", "Me", "Gr",
                                                               "Ge",   "Oe", "ksigma", "Ke", "De"};

struct document {
  double mass = 0;
  int mass_line = 0;
  int amplitudes = 0;
  int amplitudes_line = 0;
  std::vector<node> nodes{};
  std::array<series, matrix_names.size()> matrices{};

  document() {
    for (std::size_t i = 0; i < matrix_names.size(); ++i) matrices[i].called = matrix_names[i];
  }
  const series& operator[](matrix m) const { return matrices[static_cast<std::size_t>(m)]; }
};

} // namespace kanexpr::flexible::sid
