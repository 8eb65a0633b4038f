#pragma once

#include <kanexpr/exporting/files.hpp>

#include <zip.h>

#include <memory>
#include <string>
#include <vector>

namespace kanexpr::exporting {

/// Returns a zip archive of the files, uncompressed and with a fixed timestamp, so that equal files give
/// equal archives; empty if there is not enough memory.
inline std::string zipped(const std::vector<file_text>& files) {
  const auto release = [](zip_source_t* source) { zip_source_free(source); };
  const std::unique_ptr<zip_source_t, decltype(release)> bytes(
      zip_source_buffer_create(nullptr, 0, 0, nullptr), release);
  zip_t* const archive = bytes ? zip_open_from_source(bytes.get(), ZIP_TRUNCATE, nullptr) : nullptr;
  if (archive == nullptr) return {};
  zip_source_keep(bytes.get()); // the archive also releases it
  bool is_complete = true;
  for (const file_text& each : files) {
    const zip_int64_t place =
        zip_file_add(archive, each.path.generic_string().c_str(),
                     zip_source_buffer(archive, each.text.data(), each.text.size(), 0), ZIP_FL_ENC_UTF_8);
    const auto index = static_cast<zip_uint64_t>(place);
    constexpr zip_uint16_t midnight = 0, first_of_1980 = 0x21;
    is_complete = is_complete && place >= 0 &&
                  zip_set_file_compression(archive, index, ZIP_CM_STORE, 0) == 0 &&
                  zip_file_set_dostime(archive, index, midnight, first_of_1980, 0) == 0;
  }
  if (!is_complete || zip_close(archive) != 0) {
    zip_discard(archive);
    return {};
  }
  zip_stat_t size{};
  if (zip_source_stat(bytes.get(), &size) != 0 || zip_source_open(bytes.get()) != 0) return {};
  std::string all(size.size, '\0');
  const zip_int64_t read = zip_source_read(bytes.get(), all.data(), all.size());
  zip_source_close(bytes.get());
  return read == static_cast<zip_int64_t>(all.size()) ? all : std::string();
}

} // namespace kanexpr::exporting
