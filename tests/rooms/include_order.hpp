// Reads the includes of all headers and finds those that violate the order of the rooms.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rooms {

/// The text of every header, keyed by its include path: "kanexpr/base/status.hpp".
using headers = std::map<std::string, std::string>;

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

inline headers headers_in(const std::filesystem::path& include) {
  headers found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(include)) {
    const std::filesystem::path extension = entry.path().extension();
    if (extension == ".hpp" || extension == ".ipp" || extension == ".in") // .in: a text template
      found.emplace(entry.path().lexically_relative(include).generic_string(), text_of(entry.path()));
  }
  return found;
}

inline std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex each(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), each), end; i != end; ++i) found.push_back(i->str(1));
  return found;
}

/// The includes of kanexpr in quotation marks in a text, except an include at the end for definitions that no
/// library provides.
inline std::vector<std::string> includes_of(std::string text) {
  std::vector<std::string> found;
  constexpr std::string_view unless_compiled = "\n#ifndef KANEXPR_COMPILED_", behind = "\n#endif";
  for (std::size_t at; (at = text.find(unless_compiled)) != std::string::npos;)
    text.erase(at, text.find(behind, at) + behind.size() - at);
  std::string directives; // the regular expression would take seconds for all of the text
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find("include") != std::string::npos) directives += line + '\n';
  for (const std::string& line : matches(directives, "#\\s*include\\s*([<\"][^>\"]+)"))
    if (line[0] == '"' || line.starts_with("<kanexpr/")) found.push_back(line.substr(1));
  return found;
}

/// The rooms of kanexpr, from the lowest, with the folders and files that are below the rest of a room.
class order {
public:
  /// Read from the rows of a table: | `room/` | `folder`, `file.hpp`, … | page |
  explicit order(const std::string& markdown) {
    const std::regex row("\\| `([a-z/]+)/` \\|([^\\n]*)\\|");
    for (std::sregex_iterator i(markdown.begin(), markdown.end(), row), end; i != end; ++i) {
      const std::string room = i->str(1);
      for (const std::string& within : matches(i->str(2), "`([a-z0-9_./]+)`")) add(room + "/" + within);
      add(room);
      rooms_.push_back(room);
    }
  }

  const std::vector<std::string>& rooms() const { return rooms_; }

  bool empty() const { return places_.empty(); }

  /// The level of a header; nothing if no row has its folder. Headers outside of all rooms are above them.
  std::optional<std::size_t> height(const std::string& header) const {
    const std::string folder = header.substr(0, header.rfind('/'));
    if (folder == "kanexpr") return places_.size();
    const bool defines = header.ends_with(".ipp"); // declared by the headers of its folder
    for (const std::string& place : {header, defines ? folder + compiled : folder})
      if (const auto found = std::ranges::find(places_, place); found != places_.end())
        return static_cast<std::size_t>(found - places_.begin());
    return std::nullopt;
  }

private:
  void add(const std::string& place) {
    places_.push_back("kanexpr/" + place);
    places_.push_back("kanexpr/" + place + compiled);
  }

  static constexpr const char* compiled = "/*.ipp";

  std::vector<std::string> places_, rooms_;
};

/// Headers in folders that the order does not contain.
inline std::vector<std::string> homeless(const headers& all, const order& rooms) {
  std::vector<std::string> found;
  for (const auto& [header, text] : all)
    if (!rooms.height(header))
      found.push_back(header + " is in a folder that the order of the rooms does not have");
  return found;
}

inline std::vector<std::string> dangling(const headers& all) {
  std::vector<std::string> found;
  for (const auto& [header, text] : all)
    for (const std::string& included : includes_of(text))
      if (!all.contains(included)) found.push_back(header + " includes " + included + ", which is not there");
  return found;
}

inline std::vector<std::string> upward(const headers& all, const order& rooms) {
  std::vector<std::string> found;
  for (const auto& [header, text] : all)
    for (const std::string& included : includes_of(text))
      if (rooms.height(included) > rooms.height(header))
        found.push_back(header + " includes " + included + ", which stands above it");
  return found;
}

/// For each cycle, the two files at which it closes.
inline std::vector<std::string> circles(const headers& all) {
  std::vector<std::string> found;
  std::set<std::string> done, open;
  const auto visit = [&](const auto& self, const std::string& header) -> void {
    open.insert(header);
    for (const std::string& included : includes_of(all.at(header))) {
      if (!all.contains(included)) continue;
      if (open.contains(included))
        found.push_back(header + " includes " + included + ", which includes it in turn");
      else if (!done.contains(included))
        self(self, included);
    }
    open.erase(header);
    done.insert(header);
  };
  for (const auto& [header, text] : all)
    if (!done.contains(header)) visit(visit, header);
  return found;
}

} // namespace rooms
