#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace kanexpr {

/// @internal Serializes values to bytes in the representation of this machine, for a file or another process.
class bytes_writer {
public:
  template <class Value>
    requires std::is_arithmetic_v<Value>
  void put(Value value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(std::string_view text) {
    put(text.size());
    bytes_ += text;
  }
  template <class Value>
    requires std::is_arithmetic_v<Value>
  void put(const std::vector<Value>& values) {
    put(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }

  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_{};
};

/// @internal 64-bit content hash: FNV-1a (Fowler, Noll & Vo).
constexpr std::uint64_t content_hash(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char each : content) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3;
  return hash;
}

/// @internal Reads the values back in the same order. If the bytes end too early, the current and all
/// following values are zero or empty.
class bytes_reader {
public:
  explicit bytes_reader(std::string_view bytes) : left_(bytes) {}

  template <class Value>
    requires std::is_arithmetic_v<Value>
  Value get() {
    Value value{};
    if (const std::string_view from = take(sizeof value); !from.empty())
      std::memcpy(&value, from.data(), from.size());
    return value;
  }
  std::string get_text() { return std::string(take(get<std::size_t>())); }
  template <class Value>
    requires std::is_arithmetic_v<Value>
  std::vector<Value> get_all() {
    const auto count = get<std::size_t>();
    if (count > left_.size() / sizeof(Value)) {
      fail();
      return {};
    }
    std::vector<Value> values(count);
    const std::string_view from = take(count * sizeof(Value));
    if (!from.empty()) std::memcpy(values.data(), from.data(), from.size());
    return values;
  }

  /// True if no bytes were missing.
  explicit operator bool() const { return is_sound_; }
  bool is_at_end() const { return is_sound_ && left_.empty(); }

private:
  std::string_view take(std::size_t count) {
    if (count > left_.size()) fail();
    if (!is_sound_) return {};
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(taken.size());
    return taken;
  }
  void fail() { is_sound_ = false, left_ = {}; }

  std::string_view left_;
  bool is_sound_ = true;
};

} // namespace kanexpr
