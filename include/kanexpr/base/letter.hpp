#pragma once

#include <concepts>

namespace kanexpr::numeric {

/// Character types, which C++ converts to numbers silently: '2' is 50.
template <class Value>
concept letter = std::same_as<Value, char> || std::same_as<Value, wchar_t> || std::same_as<Value, char8_t> ||
                 std::same_as<Value, char16_t> || std::same_as<Value, char32_t>;

} // namespace kanexpr::numeric
