#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/base/mesh_kind.hpp>
#include <kanexpr/base/outcome.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Reads mesh files in the form in which a page embeds them.
namespace kanexpr::animate {

/// Encodes bytes in base64 (RFC 4648).
inline std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string written;
  written.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t given = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < given ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) written += k <= given ? letters[three >> (18 - 6 * k) & 63u] : '=';
  }
  return written;
}

struct mesh_file {
  std::string name{}; ///< as specified in the picture
  std::string data{}; ///< in base64
};

/// The files of all meshes in an animation, each of them once, or the reason why one of them cannot be
/// embedded in a page.
class mesh_files : public outcome {
public:
  explicit mesh_files(std::string cause) : outcome(std::move(cause)) {}
  explicit mesh_files(std::vector<mesh_file> read) : all_(std::move(read)) {}

  const std::vector<mesh_file>& all() const { return all_; }

private:
  std::vector<mesh_file> all_{};
};

/// Browsers reject much longer texts.
inline constexpr std::uintmax_t most_bytes_of_meshes = 256'000'000;

inline bool holds(const std::vector<mesh_file>& files, const std::string& name) {
  for (const mesh_file& f : files)
    if (f.name == name) return true;
  return false;
}

inline mesh_files read_meshes(const animation& a, const std::string& folder) {
  std::vector<mesh_file> read;
  std::uintmax_t bytes = 0;
  for (const animation::shape& s : a.shapes) {
    if (s.kind != "mesh" || holds(read, s.file)) continue;
    const std::filesystem::path path = std::filesystem::path(folder) / s.file;
    const std::string whose = "the file of the " + s.name + ", " + path.string() + ",";
    if (mesh_kind_of(s.file).empty()) return mesh_files(whose + " is not of the type .stl, .dae or .obj");
    std::error_code failed;
    if (!std::filesystem::exists(path, failed)) return mesh_files(whose + " does not exist");
    if (!std::filesystem::is_regular_file(path, failed)) return mesh_files(whose + " is not a file");
    const std::uintmax_t size = std::filesystem::file_size(path, failed);
    if (failed) return mesh_files(whose + " cannot be read");
    if (size == 0) return mesh_files(whose + " is empty");
    if (size > most_bytes_of_meshes - bytes)
      return mesh_files(whose + " is too large; a page can hold at most 256 MB of meshes");
    bytes += size;
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file.is_open() || file.bad() || text.size() != size) return mesh_files(whose + " cannot be read");
    read.push_back({s.file, base64(text)});
  }
  return mesh_files(std::move(read));
}

} // namespace kanexpr::animate
