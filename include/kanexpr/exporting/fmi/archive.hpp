#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kanexpr::exporting {

/// An uncompressed zip archive without file times, so that equal files give equal archives. See APPNOTE.TXT
/// by PKWARE, format version 2.0.
class archive {
public:
  void add(std::string_view path, std::string_view content) {
    const std::size_t place = files_.size();
    const std::string about = described(path, content);
    number(files_, 0x04034b50, 4);
    files_ += about;
    files_ += path;
    files_ += content;
    number(directory_, 0x02014b50, 4);
    number(directory_, version, 2); // made by
    directory_ += about;
    number(directory_, 0, 10); // no comment, one disk, no attributes
    number(directory_, place, 4);
    directory_ += path;
    ++count_;
  }

  std::string bytes() const {
    std::string all = files_ + directory_;
    number(all, 0x06054b50, 4);
    number(all, 0, 4); // one disk
    number(all, count_, 2);
    number(all, count_, 2);
    number(all, directory_.size(), 4);
    number(all, files_.size(), 4);
    number(all, 0, 2); // no comment
    return all;
  }

private:
  static constexpr std::uint64_t version = 20, first_of_1980 = 0x21;

  /// The fields that the local header and the directory entry of a file have in common.
  static std::string described(std::string_view path, std::string_view content) {
    std::string about;
    number(about, version, 2); // needed to read it
    number(about, 0, 6);       // no flags, uncompressed; midnight
    number(about, first_of_1980, 2);
    number(about, check_sum(content), 4);
    number(about, content.size(), 4);
    number(about, content.size(), 4);
    number(about, path.size(), 2);
    number(about, 0, 2); // no extra field
    return about;
  }

  static void number(std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8) to += static_cast<char>(value & 0xffu);
  }

  /// CRC-32.
  static std::uint32_t check_sum(std::string_view content) {
    std::uint32_t rest = 0xffffffffu;
    for (const char c : content) {
      rest ^= static_cast<unsigned char>(c);
      for (int i = 0; i < 8; ++i) rest = rest >> 1 ^ (0xedb88320u & (0u - (rest & 1u)));
    }
    return ~rest;
  }

  std::string files_{}, directory_{};
  std::size_t count_ = 0;
};

} // namespace kanexpr::exporting
