#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/options.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Compares matrices of a file that determine each other.
namespace kanexpr::flexible {

inline std::string number_text(double x, int digits = 6) {
  std::array<char, 32> letters{};
  const auto end =
      std::to_chars(letters.data(), letters.data() + letters.size(), x, std::chars_format::general, digits);
  return {letters.data(), end.ptr};
}

/// The position of an entry, counted from 1.
inline std::string at(int i) { return std::to_string(i + 1); }
inline std::string at(int i, int j) { return "(" + at(i) + ", " + at(j) + ")"; }

/// Values as given and as derived from other matrices, in the same order.
struct comparison {
  double natural_size = 0; ///< an upper bound of such values for any distribution of mass
  std::vector<double> given{}, derived{};

  void add(double as_given, double as_derived) {
    given.push_back(as_given);
    derived.push_back(as_derived);
  }
  /// The largest absolute value.
  double size() const {
    double largest = 0;
    for (const std::vector<double>* all : {&given, &derived})
      for (double each : *all) largest = (std::max)(largest, std::abs(each));
    return largest;
  }
  double difference(std::size_t i) const { return std::abs(given[i] - derived[i]); }
  /// The index of the largest difference.
  std::size_t worst() const {
    std::size_t found = 0;
    for (std::size_t i = 1; i < given.size(); ++i)
      if (difference(i) > difference(found)) found = i;
    return found;
  }
  double total_difference() const {
    double sum = 0;
    for (std::size_t i = 0; i < given.size(); ++i) sum += difference(i);
    return sum;
  }
  /// The largest difference relative to the largest absolute value; 0 if it is only rounding, less than a
  /// millionth of the natural size.
  double relative_difference() const {
    if (given.empty()) return 0;
    const double largest = difference(worst());
    return largest > 1e-6 * natural_size ? largest / size() : 0;
  }
};

/// Reports whether the values agree; `entry_name` returns the name of an entry, such as "Gr(3, 1)", and
/// `sources` names the matrices from which the values are derived. Line 0 denotes the whole file.
template <class EntryName>
bool agrees(const comparison& c, int line, const EntryName& entry_name, std::string_view sources,
            const reading_options& options, file_report& report) {
  const double relative = c.relative_difference();
  if (!(relative > options.agreement)) return true;
  const std::size_t worst = c.worst();
  const std::string what = entry_name(worst) + " is " + number_text(c.given[worst]) + ", but " +
                           std::string(sources) + " " + number_text(c.derived[worst]) + ", a difference of " +
                           number_text(100 * relative, 3) + " % of the largest entry";
  if (!options.prefer_derived) return report.fail(line, what + "; prefer_derived accepts such files");
  report.note(line, what);
  return true;
}

/// Adds the symmetric part of a matrix to `into`, row by row, and reports whether the matrix is symmetric.
/// `entry(k, l)` returns an entry, and `entry_name(k, l)` its name.
template <class Entry, class EntryName>
bool add_symmetric(const Entry& entry, int amplitudes, base::sequence<double>& into, int line,
                   const EntryName& entry_name, const reading_options& options, file_report& report) {
  comparison symmetry;
  for (int k = 0; k < amplitudes; ++k)
    for (int l = 0; l < amplitudes; ++l) {
      into[k * amplitudes + l] += (entry(k, l) + entry(l, k)) / 2;
      symmetry.add(entry(k, l), entry(l, k));
    }
  const auto name = [&](std::size_t e) {
    return entry_name(static_cast<int>(e) / amplitudes, static_cast<int>(e) % amplitudes);
  };
  return agrees(symmetry, line, name, "the opposite entry is", options, report);
}

} // namespace kanexpr::flexible
