#pragma once

#include <kanexpr/base/bytes.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// Converts values to bytes: numbers, strings, containers, pairs, optional values, and classes that list
/// their members in a function `fields(self, archive)`.
class saver {
public:
  template <class... Values>
  void operator()(const Values&... all) {
    (put(all), ...);
  }
  const std::string& bytes() const { return out_.bytes(); }

private:
  template <class Value>
  void put(const Value& value) {
    if constexpr (std::is_enum_v<Value>)
      put(static_cast<std::underlying_type_t<Value>>(value));
    else if constexpr (requires { out_.put(value); })
      out_.put(value);
    else if constexpr (requires { Value::fields(value, *this); })
      Value::fields(value, *this);
    else if constexpr (requires { value.second; })
      put(value.first), put(value.second);
    else if constexpr (requires { value.has_value(); }) {
      put(value.has_value());
      if (value) put(*value);
    } else {
      put(value.size());
      for (const auto& each : value) put(each);
    }
  }

  bytes_writer out_{};
};

/// Restores the values that a `saver` has converted. Values after the end of the bytes are zero or empty.
class loader {
  template <class Value>
  struct element {
    using type = Value;
  };
  template <class Key, class Value>
  struct element<std::pair<const Key, Value>> {
    using type = std::pair<Key, Value>;
  };

public:
  explicit loader(std::string_view bytes) : in_(bytes) {}
  template <class... Values>
  void operator()(Values&... all) {
    (get(all), ...);
  }
  /// Returns false if the bytes ended too early.
  explicit operator bool() const { return static_cast<bool>(in_); }
  bool is_at_end() const { return in_.is_at_end(); }

private:
  template <class Value>
  void get(Value& value) {
    if constexpr (std::is_enum_v<Value>)
      value = static_cast<Value>(in_.get<std::underlying_type_t<Value>>());
    else if constexpr (std::is_arithmetic_v<Value>)
      value = in_.get<Value>();
    else if constexpr (std::is_same_v<Value, std::string>)
      value = in_.get_text();
    else if constexpr (requires { Value::fields(value, *this); })
      Value::fields(value, *this);
    else if constexpr (requires { value.second; })
      get(value.first), get(value.second);
    else if constexpr (std::is_arithmetic_v<typename Value::value_type>)
      value = in_.get_all<typename Value::value_type>();
    else {
      value.clear();
      for (auto left = in_.get<std::size_t>(); left > 0 && in_; --left) {
        typename element<typename Value::value_type>::type one{};
        get(one);
        value.insert(value.end(), std::move(one));
      }
    }
  }

  bytes_reader in_;
};

} // namespace kanexpr::ensembles
