#pragma once

#include <concepts>

namespace kanexpr::base {

/// A character type. C++ silently converts characters to numbers: '2' becomes 50.
template <class Value>
concept letter = std::same_as<Value, char> || std::same_as<Value, wchar_t> || std::same_as<Value, char8_t> ||
                 std::same_as<Value, char16_t> || std::same_as<Value, char32_t>;

} // namespace kanexpr::base
