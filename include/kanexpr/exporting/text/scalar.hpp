#pragma once

#include <charconv>
#include <string>

namespace kanexpr::exporting {

/// The scalar type of exported code: double or float.
enum class precision : unsigned char { double_precision, single_precision };

/// A scalar type in C.
struct scalar {
  bool is_single = false;

  constexpr explicit scalar(precision of) : is_single(of == precision::single_precision) {}

  const char* type() const { return is_single ? "float" : "double"; }
  /// The unsigned integer type of the same size.
  const char* bits() const { return is_single ? "unsigned int" : "unsigned long long"; }
  const char* last_bit() const { return is_single ? "31" : "63"; }
  const char* exponent_bits() const { return is_single ? "0x7f800000u" : "0x7ff0000000000000ull"; }
  /// The last bit of the exponent.
  const char* unit_of_exponent() const { return is_single ? "0x00800000u" : "0x0010000000000000ull"; }
  /// The name of a function of math.h: `sqrt` or `sqrtf`.
  std::string function(const std::string& name) const { return is_single ? name + 'f' : name; }

  /// Returns the number rounded to this type, with enough digits to restore it exactly.
  std::string number(double value) const {
    char letters[40];
    char* const end = is_single
                          ? std::to_chars(letters, letters + sizeof letters, static_cast<float>(value)).ptr
                          : std::to_chars(letters, letters + sizeof letters, value).ptr;
    std::string digits(letters, end);
    if (digits.find_first_of(".e") == std::string::npos) digits += ".0";
    return is_single ? digits + 'f' : digits;
  }
};

} // namespace kanexpr::exporting
