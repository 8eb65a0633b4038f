#pragma once

#include "flexible/lumped_body.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

/// Standard input data of bodies that consist of particles. Every matrix is formed from its own definition as
/// an integral, in two notations of real programs.
namespace lumped {

/// How a program writes a file.
struct notation {
  bool amplitude_second = true;  ///< m1(row, amplitude, column) instead of m1(row, column, amplitude)
  bool fortran = true;           ///< the exponent has the letter D
  bool inertia_as_vector = true; ///< J has 6 rows: xx, yy, zz, xy, xz, yz
  bool ge_by_axis = false;       ///< the columns of Ge are ordered by axis
  bool with_zeros = false;       ///< writes entries that are zero
  bool second_order = false;     ///< writes the terms of second order that others determine
  const char* frame = "frame";
  const char* digits = "%.16E";
};

inline const notation fembs{};
inline const notation matlab{.amplitude_second = false,
                             .fortran = false,
                             .inertia_as_vector = false,
                             .with_zeros = true,
                             .frame = "new frame"};

/// Writes standard input data. The functions `zeroth` and `first` give the entries of a series.
class sid_writer {
public:
  sid_writer(const body& b, const notation& how) : b_(b), how_(how), n_(b.amplitudes) {}

  std::string write() {
    text_ = " 1 " + std::to_string(n_) + " : No. nodes, No. modes : a test\n part\n  new modal =\n";
    line("refmod"), line("mass = " + number(b_.mass())), line("nelastq = " + std::to_string(n_));
    for (int k = 1; k <= n_; ++k) line("ielastq ( " + std::to_string(k) + ") = Eigen Mode : 1.0 Hz");
    line("end refmod"), line(how_.frame);
    write_node();
    line("end frame");
    write_integrals();
    write_rates();
    write_elasticity();
    text_ += "  end modal\n end part\n";
    return text_;
  }

private:
  using entry = std::function<double(int, int)>;
  using linear_entry = std::function<double(int, int, int)>;
  using second_entry = std::function<double(int, int, int, int)>; ///< a second derivative

  void line(const std::string& what) { text_ += "     " + what + "\n"; }
  std::string number(double x) const {
    std::array<char, 40> letters{};
    std::snprintf(letters.data(), letters.size(), how_.digits, x);
    std::string written = letters.data();
    if (const std::size_t e = written.find('E'); how_.fortran && e != written.npos) written[e] = 'D';
    return written;
  }
  static std::string index_text(int i, int j) { return std::to_string(i + 1) + ", " + std::to_string(j + 1); }

  void series(const std::string& called, int rows, int columns, const entry& zeroth,
              const linear_entry& first = {}, int structure = 3, const second_entry& second = {}) {
    line(called);
    line("order = " + std::to_string(second ? 2 : first ? 1 : 0));
    line("nrow = " + std::to_string(rows)), line("ncol = " + std::to_string(columns));
    line("nq = " + std::to_string(n_)), line("nqn = 0");
    line("structure = " + std::to_string(structure));
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < (structure == 2 ? i + 1 : columns); ++j)
        if (zeroth(i, j) != 0 || how_.with_zeros)
          line("m0( " + index_text(i, j) + ") = " + number(zeroth(i, j)));
    for (int i = 0; i < rows && first; ++i)
      for (int j = 0; j < columns; ++j)
        for (int k = 0; k < n_; ++k) {
          if (first(i, j, k) == 0 && !how_.with_zeros) continue;
          line("m1( " + index_text(i, how_.amplitude_second ? k : j) + ", " +
               std::to_string((how_.amplitude_second ? j : k) + 1) + ") = " + number(first(i, j, k)));
        }
    for (int i = 0; i < rows && second; ++i)
      for (int j = 0; j < columns; ++j)
        for (int k = 0; k < n_; ++k)
          for (int l = 0; l <= k; ++l) { // twice, because the opposite entry is not written
            const double value = second(i, j, k, l) / (k == l ? 2 : 1);
            const std::string amplitudes = index_text(k, l);
            line("m2( " + std::to_string(i + 1) + ", " +
                 (how_.amplitude_second ? amplitudes + ", " + std::to_string(j + 1)
                                        : std::to_string(j + 1) + ", " + amplitudes) +
                 ") = " + number(value));
          }
    line("end " + called);
  }
  second_entry if_second_order(const second_entry& second) const {
    return how_.second_order ? second : second_entry{};
  }

  void write_node() {
    const particle& p = b_.particles.back();
    line("new node = 12"), line("rframe = body ref");
    series(
        "origin", 3, 1, [&](int i, int) { return p.place[i]; },
        [&](int i, int, int k) { return p.shape_of(k)[i]; }, 3,
        if_second_order([&](int i, int, int k, int l) { return p.bend_of(k, l)[i]; }));
    series(
        "phi", 3, n_, [&](int i, int k) { return p.shape_of(k)[i]; },
        [&](int i, int k, int l) { return p.bend_of(k, l)[i]; });
    const linear_entry bend = [&](int i, int k, int l) { return psi_rate(k, l)[i]; };
    series(
        "psi", 3, n_, [&](int i, int k) { return turn(k)[i]; },
        b_.turn_bends.empty() ? linear_entry{} : bend);
    series(
        "AP", 3, 3, [&](int i, int j) { return b_.axes(i, j); },
        [&](int i, int j, int k) {
          const Eigen::Matrix3d rate = skew(turn(k)) * b_.axes;
          return rate(i, j);
        },
        3, if_second_order([&](int i, int j, int k, int l) {
          const Eigen::Matrix3d a = skew(turn(k)), b = skew(turn(l)),
                                second = ((a * b + b * a) / 2 + skew(b_.turn_bend_of(k, l))) * b_.axes;
          return second(i, j);
        }));
    line("end node");
  }
  const Vector3d& turn(int k) const { return b_.turns[static_cast<std::size_t>(k)]; }
  /// The derivative of psi: the angular velocity is θ' + ½ θ × θ' + ….
  Vector3d psi_rate(int k, int l) const { return b_.turn_bend_of(k, l) + turn(l).cross(turn(k)) / 2; }

  void write_integrals() {
    const Vector3d moment = b_.integral<Vector3d>([](const particle& p) -> Vector3d { return p.place; });
    series(
        "mdCM", 3, 1, [&](int i, int) { return moment[i]; },
        [&](int i, int, int k) { return translation(k)[i]; }, 3,
        if_second_order([&](int i, int, int k, int l) { return bend(k, l)[i]; }));
    const Eigen::Matrix3d inertia = b_.integral<Eigen::Matrix3d>(
        [](const particle& p) -> Eigen::Matrix3d { return inertia_form(p.place, p.place); });
    const auto rate = [&](int k) -> Eigen::Matrix3d {
      return b_.integral<Eigen::Matrix3d>(
          [&](const particle& p) -> Eigen::Matrix3d { return 2 * inertia_form(p.place, p.shape_of(k)); });
    };
    const auto second = [&](int k, int l) -> Eigen::Matrix3d {
      return b_.integral<Eigen::Matrix3d>([&](const particle& p) -> Eigen::Matrix3d {
        return 2 * inertia_form(p.shape_of(k), p.shape_of(l)) + 2 * inertia_form(p.place, p.bend_of(k, l));
      });
    };
    static constexpr int rows[6]{0, 1, 2, 0, 0, 1}, columns[6]{0, 1, 2, 1, 2, 2};
    if (how_.inertia_as_vector)
      series(
          "J", 6, 1, [&](int e, int) { return inertia(rows[e], columns[e]); },
          [&](int e, int, int k) { return rate(k)(rows[e], columns[e]); }, 3,
          if_second_order([&](int e, int, int k, int l) { return second(k, l)(rows[e], columns[e]); }));
    else
      series(
          "J", 3, 3, [&](int i, int j) { return inertia(i, j); },
          [&](int i, int j, int k) { return rate(k)(i, j); }, 2,
          if_second_order([&](int i, int j, int k, int l) { return second(k, l)(i, j); }));
    series(
        "Ct", n_, 3, [&](int k, int i) { return translation(k)[i]; },
        [&](int k, int i, int l) { return bend(k, l)[i]; });
    series(
        "Cr", n_, 3,
        [&](int k, int i) {
          return b_.integral<Vector3d>(
              [&](const particle& p) -> Vector3d { return p.place.cross(p.shape_of(k)); })[i];
        },
        [&](int k, int i, int l) {
          return b_.integral<Vector3d>([&](const particle& p) -> Vector3d {
            return p.shape_of(l).cross(p.shape_of(k)) + p.place.cross(p.bend_of(k, l));
          })[i];
        });
  }
  Vector3d translation(int k) const {
    return b_.integral<Vector3d>([&](const particle& p) -> Vector3d { return p.shape_of(k); });
  }

  Vector3d bend(int k, int l) const {
    return b_.integral<Vector3d>([&](const particle& p) -> Vector3d { return p.bend_of(k, l); });
  }

  void write_rates() {
    series(
        "Me", n_, n_,
        [&](int k, int l) {
          double sum = 0;
          for (const particle& p : b_.particles) sum += p.mass * p.shape_of(k).dot(p.shape_of(l));
          return sum;
        },
        {}, 2);
    const linear_entry gyroscopic_rate = [&](int i, int column, int l) {
      return b_.integral<Eigen::Matrix3d>([&](const particle& p) -> Eigen::Matrix3d {
        return -2 * (skew(p.shape_of(l)) * skew(p.shape_of(column / 3)) +
                     skew(p.place) * skew(p.bend_of(column / 3, l)));
      })(i, column % 3);
    };
    series(
        "Gr", 3, 3 * n_,
        [&](int i, int column) {
          return b_.integral<Eigen::Matrix3d>([&](const particle& p) -> Eigen::Matrix3d {
            return -2 * skew(p.place) * skew(p.shape_of(column / 3));
          })(i, column % 3);
        },
        how_.second_order ? gyroscopic_rate : linear_entry{});
    series("Ge", n_, 3 * n_, [&](int k, int column) {
      const int l = how_.ge_by_axis ? column % n_ : column / 3,
                i = how_.ge_by_axis ? column / n_ : column % 3;
      return b_.integral<Vector3d>(
          [&](const particle& p) -> Vector3d { return 2 * p.shape_of(l).cross(p.shape_of(k)); })[i];
    });
    series(
        "Oe", n_, 6,
        [&](int k, int e) {
          return b_.integral<six_numbers>(
              [&](const particle& p) -> six_numbers { return centrifugal_form(p.shape_of(k), p.place); })[e];
        },
        [&](int k, int e, int l) {
          return b_.integral<six_numbers>([&](const particle& p) -> six_numbers {
            return centrifugal_form(p.shape_of(k), p.shape_of(l)) +
                   centrifugal_form(p.bend_of(k, l), p.place);
          })[e];
        });
  }

  void write_elasticity() {
    // ksigma and Ke share the terms of second order in the force; a tenth of the stiffness is that of
    // stresses
    const bool has_third = !b_.third.empty();
    const double share = b_.preload.empty() ? 0 : 0.1;
    const linear_entry prestress = [&](int k, int, int l) { return share * b_.stiffness(k, l); },
                       softening = [&](int k, int l, int m) { return 0.3 * b_.entry(b_.third, k, l, m); },
                       rate = [&](int k, int l, int m) { return b_.entry(b_.damping_rate, k, l, m); };
    const second_entry rest = [&](int k, int, int l, int m) { return 0.4 * b_.entry(b_.third, k, l, m); },
                       hardening = [&](int k, int l, int m,
                                       int n) { return b_.entry(b_.fourth, k, l, m, n) / 3; },
                       second_rate = [&](int k, int l, int m, int n) {
                         return b_.entry(b_.second_damping_rate, k, l, m, n);
                       };
    series(
        "ksigma", n_, 1, [&](int k, int) { return b_.entry(b_.preload, k); },
        share > 0 ? prestress : linear_entry{}, 3, has_third ? rest : second_entry{});
    series(
        "Ke", n_, n_, [&](int k, int l) { return (1 - share) * b_.stiffness(k, l); },
        has_third ? softening : linear_entry{}, 2, b_.fourth.empty() ? second_entry{} : hardening);
    series(
        "De", n_, n_, [&](int k, int l) { return b_.damping(k, l); },
        b_.damping_rate.empty() ? linear_entry{} : rate, 3,
        b_.second_damping_rate.empty() ? second_entry{} : second_rate);
  }

  const body& b_;
  const notation& how_;
  int n_;
  std::string text_{};
};

inline std::string sid_text(const body& b, const notation& how) { return sid_writer(b, how).write(); }

} // namespace lumped
