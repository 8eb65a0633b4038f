#pragma once

#include <kanexpr/base/file_path.hpp>
#include <kanexpr/base/file_text.hpp>
#include <kanexpr/base/outcome.hpp>
#include <kanexpr/runtime/building/tyre_data.hpp>
#include <kanexpr/runtime/tir_keys.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

/// Tyres from files with tyre properties (.tir).
namespace kanexpr::runtime {

/// The coefficients of a tyre for `tyre_data::of_formula`, or the reason why they could not be read: "line 12
/// of slick.tir: PCX1 is abc, which is not a finite number".
struct [[nodiscard]] read_tyre : outcome {
  using outcome::outcome;

  tyre_data::coefficients coefficients{};
  double nominal_load = 0;                  ///< FNOMIN, in N
  double unloaded_radius = 0;               ///< in m
  std::optional<double> radial_stiffness{}; ///< VERTICAL_STIFFNESS, in N/m
  /// LEFT or RIGHT if the tyre is not symmetric. The tyre of the other side is its mirror image.
  std::string side{};
  /// Sentences about coefficients that are ignored.
  std::vector<std::string> notes{};
};

namespace detail {

/// Reads lines `KEY = value $ comment` in sections `[NAME]`.
class tir_reader {
public:
  explicit tir_reader(std::string called) : called_(std::move(called)) {}

  read_tyre read(std::string_view text) {
    for (; !text.empty() && mistake_.empty(); ++line_) {
      const std::size_t end = text.find('\n');
      take(trimmed(text.substr(0, text.find_first_of("$!\n"))));
      text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    line_ = 0;
    if (!seen_.contains("FNOMIN")) fail("FNOMIN, the nominal load, is missing");
    if (!seen_.contains("UNLOADED_RADIUS")) fail("UNLOADED_RADIUS is missing");
    if (!seen_.contains("FITTYP"))
      note("FITTYP is missing; the coefficients are taken as those of version 6.1");
    if (!mistake_.empty()) tyre_ = read_tyre(mistake_);
    return std::move(tyre_);
  }

private:
  static std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  }
  static std::string in_capitals(std::string_view text) {
    std::string all(text);
    for (char& c : all)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return all;
  }
  /// Text from the file, without control characters and not too long for a message.
  static std::string printable(std::string_view text) {
    std::string plain;
    for (const char c : text.substr(0, 40))
      plain += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return text.size() > 40 ? plain + "..." : plain;
  }

  std::string at() const {
    return line_ == 0 ? called_ + ": " : "line " + std::to_string(line_) + " of " + called_ + ": ";
  }
  void fail(const std::string& what) {
    if (mistake_.empty()) mistake_ = at() + what;
  }
  void note(const std::string& what) { tyre_.notes.push_back(at() + what); }

  void take(std::string_view line) {
    if (line.empty()) return;
    if (line.front() == '[') {
      section_ = in_capitals(line);
      is_table_ = false;
    } else if (line.front() == '{' || line.front() == '(') {
      is_table_ = true; // a table or comments, to the end of the section
    } else if (!is_table_) {
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos) return fail("expected KEY = value, got " + printable(line));
      take(in_capitals(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
    }
  }

  void take(const std::string& key, std::string_view value) {
    if (section_ == "[UNITS]") return check_unit(key, value); // MASS is also a property
    if (const auto [before, is_new] = seen_.emplace(key, line_); !is_new)
      return fail(printable(key) + " is given twice, first in line " + std::to_string(before->second));
    if (key == "TYRESIDE") return take_side(value);
    if (key == "FITTYP") return check_version(value);
    const tir_key known = find_tir_key(key);
    if (known.coefficient == nullptr && key != "VERTICAL_STIFFNESS") return ignore(key);
    const std::optional<double> number = number_of(value);
    if (!number) return fail(printable(key) + " is " + printable(value) + ", which is not a finite number");
    if (known.coefficient == nullptr)
      tyre_.radial_stiffness = number;
    else
      tyre_.coefficients.*known.coefficient = *number;
    if (key == "FNOMIN") tyre_.nominal_load = *number;
    if (key == "UNLOADED_RADIUS") tyre_.unloaded_radius = *number;
    if ((key == "FNOMIN" || key == "UNLOADED_RADIUS") && *number <= 0) fail(key + " is not positive");
  }

  /// Dimensions, ranges and properties of the carcass belong to other parts of a model of a tyre.
  void ignore(const std::string& key) {
    if (section_.find("TURNSLIP") != std::string::npos) {
      if (!std::exchange(has_turn_slip_, true)) note("the coefficients of turn slip are ignored");
    } else if (section_.find("COEFFICIENTS") != std::string::npos)
      note(printable(key) + " is ignored; the formula has no such coefficient");
  }

  void check_unit(const std::string& key, std::string_view value) {
    struct required {
      std::string_view key, unit, also;
    };
    static constexpr required all[] = {{"LENGTH", "METER", "M"},       {"FORCE", "NEWTON", "N"},
                                       {"ANGLE", "RADIANS", "RADIAN"}, {"MASS", "KG", "KILOGRAM"},
                                       {"TIME", "SECOND", "S"},        {"PRESSURE", "PASCAL", "PA"}};
    const std::string unit = in_capitals(unquoted(value));
    for (const required& each : all)
      if (each.key == key && unit != each.unit && unit != each.also)
        fail("the unit of " + key + " is " + printable(unit) + "; it must be " + std::string(each.unit));
  }

  void take_side(std::string_view value) {
    const std::string side = in_capitals(unquoted(value));
    if (side != "LEFT" && side != "RIGHT" && side != "SYMMETRIC")
      return fail("TYRESIDE is " + printable(side) + "; it must be LEFT, RIGHT or SYMMETRIC");
    if (side != "SYMMETRIC") tyre_.side = side;
  }

  void check_version(std::string_view value) {
    const std::optional<double> number = number_of(value);
    for (const double version : {60.0, 61.0, 62.0})
      if (number && std::abs(*number - version) < 0.5) return;
    fail("FITTYP is " + printable(value) +
         "; only 60, 61 and 62, the versions 6.0 to 6.2 of the Magic Formula, can be read");
  }

  static std::string_view unquoted(std::string_view value) {
    const bool is_quoted =
        value.size() >= 2 && (value.front() == '\'' || value.front() == '"') && value.back() == value.front();
    return is_quoted ? trimmed(value.substr(1, value.size() - 2)) : value;
  }
  static std::optional<double> number_of(std::string_view value) {
    if (!value.empty() && value.front() == '+') value.remove_prefix(1);
    double number = 0;
    const auto [rest, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || rest != value.data() + value.size() || !std::isfinite(number)) return {};
    return number;
  }

  std::string called_;
  int line_ = 1;
  std::string section_{}, mistake_{};
  bool is_table_ = false, has_turn_slip_ = false;
  std::map<std::string, int> seen_{};
  read_tyre tyre_{};
};

} // namespace detail

/// Reads tyre properties from text; `called` names the file in messages.
inline read_tyre read_tir_text(std::string_view text, const std::string& called = "the text") {
  return detail::tir_reader(called).read(text);
}

/// Reads the coefficients of the Magic Formula from a file with tyre properties (.tir) of the versions 6.0 to
/// 6.2 (FITTYP 60, 61 or 62), in SI units: `auto t = tyre_data::of_formula(read_tir(path).coefficients);`.
/// The load and the `standstill` of the tyre are set before `b.tyre(wheel, t)`. Coefficients that the formula
/// does not have are noted.
inline read_tyre read_tir(const file_path& path) {
  const std::optional<std::string> text = base::text_of(path);
  if (!text) return read_tyre(path.text() + " cannot be read");
  return read_tir_text(*text, path.text().substr(path.text().rfind('/') + 1));
}

} // namespace kanexpr::runtime
