#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/bent_tracks.hpp>
#include <kanexpr/animate/tracks.hpp>
#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/mesh_kind.hpp>
#include <kanexpr/base/name_of_time.hpp>
#include <kanexpr/base/outcome.hpp>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Converts an animation to the text that the page reads, and mesh files to the form that it embeds.
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

/// The files of all meshes in an animation, each listed once, or the reason why one of them cannot be
/// embedded in a page.
struct mesh_files : outcome {
  using outcome::outcome;

  std::vector<mesh_file> all{};
};

/// The content of a mesh file, or the reason why it cannot be read.
struct mesh_file_read : outcome {
  using outcome::outcome;

  std::string bytes{};
};

/// Browsers reject much longer strings.
inline constexpr std::uintmax_t most_bytes_of_meshes = 256'000'000;

/// Whether one of the files or columns has the given name.
template <class Named>
bool is_among(const std::vector<Named>& all, const std::string& name) {
  return std::ranges::find(all, name, &Named::name) != all.end();
}

/// Reads the file of a mesh, of which at most `room` bytes fit into the page.
inline mesh_file_read read_mesh(const animation::shape& s, const std::string& folder, std::uintmax_t room) {
  const std::filesystem::path path = std::filesystem::path(folder) / s.file;
  const std::string whose = "the file of the " + s.name + ", " + path.string() + ",";
  if (mesh_kind_of(s.file).empty()) return mesh_file_read(whose + " is not of the type .stl, .dae or .obj");
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) return mesh_file_read(whose + " does not exist");
  if (!std::filesystem::is_regular_file(path, failed)) return mesh_file_read(whose + " is not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (failed) return mesh_file_read(whose + " cannot be read");
  if (size == 0) return mesh_file_read(whose + " is empty");
  if (size > room) return mesh_file_read(whose + " is too large; a page can hold at most 256 MB of meshes");
  std::ifstream file(path, std::ios::binary);
  mesh_file_read read;
  read.bytes.assign(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad() || read.bytes.size() != size)
    return mesh_file_read(whose + " cannot be read");
  return read;
}

/// Reads the files of all runs. A relative name is resolved in `folder`, or in the folder of the picture if
/// it is empty.
inline mesh_files read_meshes(const std::vector<named_animation>& runs, const std::string& folder) {
  mesh_files read;
  std::uintmax_t room = most_bytes_of_meshes;
  for (const named_animation& run : runs)
    for (const animation::shape& s : run.motion.shapes) {
      if (s.kind != "mesh" || is_among(read.all, s.file)) continue;
      const mesh_file_read one = read_mesh(s, folder.empty() ? run.motion.folder : folder, room);
      if (!one) return mesh_files(one.cause());
      room -= one.bytes.size();
      read.all.push_back({s.file, base64(one.bytes)});
    }
  return read;
}

/// Rounds to seven digits; the difference is not visible.
inline double rounded(double value) {
  char digits[32];
  const char* end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 7).ptr;
  double shorter = value;
  std::from_chars(digits, end, shorter);
  return base::equal(shorter, 0.0) ? 0 : shorter; // no −0
}

inline nlohmann::json list_of(const std::vector<double>& values) {
  nlohmann::json all = nlohmann::json::array();
  for (double v : values) all.push_back(rounded(v));
  return all;
}

inline nlohmann::json list_of(const Eigen::Vector3d& v) {
  return list_of(std::vector<double>(v.begin(), v.end()));
}

inline std::vector<double> numbers_of_turn(const Eigen::Matrix3d& orientation) {
  const Eigen::Quaterniond turned(orientation);
  return {turned.x(), turned.y(), turned.z(), turned.w()};
}

/// Rounds to seven decimals of the power of ten above `largest`.
class decimals {
public:
  explicit decimals(double largest)
      : exponent_(largest > 0 ? 7 - static_cast<int>(std::ceil(std::log10(largest))) : 0),
        power_(std::pow(10.0, std::abs(exponent_))) {}

  double rounded(double value) const {
    const double whole =
        exponent_ < 0 ? (std::round)(value / power_) * power_ : (std::round)(value * power_) / power_;
    return base::equal(whole, 0.0) ? 0 : whole; // no −0
  }

private:
  int exponent_;
  double power_;
};

/// Returns the rows of a track: 3 numbers for each time, or 7 for a body, whose last four are the quaternion
/// x, y, z, w. A track that stays in place has one row.
inline nlohmann::json track_text(const track& t) {
  const decimals places(t.positions.cwiseAbs().maxCoeff()), turns(1);
  std::vector<double> rows, row, first;
  bool moves = false;
  for (Eigen::Index k = 0; k < t.positions.cols(); ++k) {
    row.clear();
    for (const double x : t.positions.col(k)) row.push_back(places.rounded(x));
    if (t.is_body())
      for (const double x : numbers_of_turn(t.orientations[static_cast<std::size_t>(k)]))
        row.push_back(turns.rounded(x));
    if (k == 0) first = row;
    moves = moves || row != first;
    rows.insert(rows.end(), row.begin(), row.end());
  }
  return {{"turns", t.is_body()}, {"rows", moves ? rows : first}};
}

/// Returns the tracks that bend relative to a base: the mean and the deflections of each, and the weights of
/// the deflections at all times, which they share.
inline nlohmann::json bending_text(const bending& b) {
  nlohmann::json parts = nlohmann::json::array();
  for (std::size_t i = 0; i < b.tracks.size(); ++i) {
    const auto numbers_of_part = [&](const auto& column) {
      Eigen::VectorXd numbers = column.template segment<6>(6 * static_cast<Eigen::Index>(i));
      numbers.head<3>() *= b.size;
      return std::vector<double>(numbers.begin(), numbers.end());
    };
    nlohmann::json deflections = nlohmann::json::array();
    for (Eigen::Index k = 0; k < b.deflections.cols(); ++k)
      deflections.push_back(list_of(numbers_of_part(b.deflections.col(k))));
    parts.push_back(
        {{"track", b.tracks[i]}, {"mean", list_of(numbers_of_part(b.mean))}, {"deflections", deflections}});
  }
  const decimals digits(b.weights.size() > 0 ? b.weights.lpNorm<Eigen::Infinity>() : 1);
  nlohmann::json rows = nlohmann::json::array();
  for (const double weight : b.weights.reshaped()) rows.push_back(digits.rounded(weight));
  return {{"base", b.base}, {"rows", rows}, {"parts", parts}};
}

inline nlohmann::json anchor_text(const anchor& a, bool turns) {
  nlohmann::json one{{"track", a.track}};
  if (!a.position.isZero(0)) one["at"] = list_of(a.position);
  if (turns && !a.orientation.isIdentity(0)) one["turn"] = list_of(numbers_of_turn(a.orientation));
  return one;
}

/// `undeformed` are the anchors while no flexible body is deformed; empty if they are the same.
inline nlohmann::json shape_text(const animation::shape& s, const std::vector<anchor>& anchors,
                                 const std::vector<anchor>& undeformed) {
  constexpr const char* kinds_of_placement[]{"place", "ends", "pose"};
  nlohmann::json one{{"name", s.name},
                     {"kind", s.kind},
                     {"placed", kinds_of_placement[static_cast<int>(s.placed_by)]},
                     {"opacity", s.opacity},
                     {"sizes", list_of(s.sizes)},
                     {"anchors", nlohmann::json::array()}};
  const bool turns = s.placed_by == placement_kind::pose;
  for (const anchor& a : anchors) one["anchors"].push_back(anchor_text(a, turns));
  for (std::size_t i = 0; i < undeformed.size(); ++i)
    one["anchors"][i]["undeformed"] = anchor_text(undeformed[i], turns);
  if (!s.colour.empty()) one["colour"] = s.colour;
  if (!s.profile.empty()) one["profile"] = s.profile;
  if (!s.straight_parts.empty()) one["straight"] = s.straight_parts;
  if (!s.file.empty()) one["file"] = s.file;
  if (!s.layer.empty()) one["layer"] = s.layer;
  if (!s.unit.empty()) one["unit"] = s.unit;
  return one;
}

/// Returns the motion of one run: its times, tracks, shapes and columns. A track that bends is null, and is
/// given by one of the bendings.
inline nlohmann::json run_text(const std::string& name, const animation& a) {
  nlohmann::json run{{"name", name},
                     {"times", a.times}, // exactly; the steps may be small compared with them
                     {"tracks", nlohmann::json::array()},
                     {"shapes", nlohmann::json::array()},
                     {"columns", nlohmann::json::array()}};
  const tracks found = tracks_of(a);
  for (const track& t : found.all) run["tracks"].push_back(track_text(t));
  run["bendings"] = nlohmann::json::array();
  for (const bending& b : bendings_of(a, found)) {
    run["bendings"].push_back(bending_text(b));
    for (const std::size_t i : b.tracks) run["tracks"][i] = nullptr;
  }
  for (std::size_t i = 0; i < a.shapes.size(); ++i)
    run["shapes"].push_back(shape_text(a.shapes[i], found.of_shape[i], found.undeformed[i]));
  for (const animation::column& c : a.columns)
    run["columns"].push_back(
        {{"name", c.name}, {"group", c.group}, {"unit", c.unit}, {"values", list_of(c.values)}});
  return run;
}

inline std::string written(const nlohmann::json& all) {
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Replaces invalid UTF-8 by U+FFFD.
inline std::string valid_utf8(const std::string& text) {
  return nlohmann::json::parse(written(text)).get<std::string>();
}

inline nlohmann::json file_text(const mesh_file& f) {
  return {{"name", f.name}, {"kind", mesh_kind_of(f.name)}, {"data", f.data}};
}

inline bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }

/// Returns runs as JSON; the first one determines the view. The text contains no `<`, so it can be inserted
/// into a page without escaping.
inline std::string page_text(const std::vector<named_animation>& runs, const std::string& title,
                             const std::string& text, const std::vector<mesh_file>& files = {}) {
  const animation& first = runs.front().motion;
  const auto is_taken = [&](const std::string& name) {
    return std::ranges::any_of(
        runs, [&](const named_animation& run) { return is_among(run.motion.columns, name); });
  };
  nlohmann::json all{{"title", title},
                     {"text", text},
                     {"nameOfTime", base::name_of_time(is_taken)},
                     {"up", list_of(first.up)},
                     {"carried", first.carried},
                     {"runs", nlohmann::json::array()},
                     {"files", nlohmann::json::array()}};
  if (first.seen_from) all["seenFrom"] = list_of(*first.seen_from);
  if (first.ground) all["ground"] = rounded(*first.ground);
  for (const named_animation& run : runs) all["runs"].push_back(run_text(run.name, run.motion));
  for (const mesh_file& f : files) all["files"].push_back(file_text(f));
  std::string page = written(all);
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at))
    page.replace(at, 1, "\\u003c");
  return page;
}

} // namespace kanexpr::animate
