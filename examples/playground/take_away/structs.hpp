#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace playground {

/// Structs of frames, points and bodies. A text may name a frame or a point before its line; in C++, the
/// struct must come first.
class structs {
public:
  void add(const std::string& name, const std::string& bases) { all_.push_back({name, bases}); }

  /// The structs in their order, except that each follows those that it names.
  std::string text() const {
    std::string text;
    for (const one& each : in_order()) text += "struct " + each.name + " : " + each.bases + " {};\n";
    return text;
  }

  /// Names two structs that contain each other, for which there is no order.
  std::string mistake() const {
    const std::vector<one> written = in_order();
    const auto is_missing = [&](const one& each) { return !holds(written, each.name); };
    auto at = std::ranges::find_if(all_, is_missing);
    if (at == all_.end()) return "";
    const auto named_by = [&](const one& by) {
      const std::set<std::string> named = names_in(by.bases);
      return std::ranges::find_if(all_, [&](const one& each) {
        return each.name != by.name && is_missing(each) && named.contains(each.name);
      });
    };
    for (std::size_t i = 0; i < all_.size(); ++i) at = named_by(*at); // ends in a circle
    return at->name + " is given in terms of " + named_by(*at)->name + ", which follows from it; C++ types " +
           "cannot name each other";
  }

private:
  struct one {
    std::string name{}, bases{};
  };

  /// As many structs as possible, each after those that it names.
  std::vector<one> in_order() const {
    std::vector<one> written, waiting = all_;
    const auto is_ready = [&](const one& each) {
      const std::set<std::string> named = names_in(each.bases);
      return std::ranges::none_of(
          waiting, [&](const one& other) { return other.name != each.name && named.contains(other.name); });
    };
    for (auto next = std::ranges::find_if(waiting, is_ready); next != waiting.end();
         next = std::ranges::find_if(waiting, is_ready)) {
      written.push_back(*next);
      waiting.erase(next);
    }
    return written;
  }

  static bool holds(const std::vector<one>& all, const std::string& name) {
    return std::ranges::any_of(all, [&](const one& each) { return each.name == name; });
  }

  /// The identifiers in a text, without those after :: and in quotation marks.
  static std::set<std::string> names_in(const std::string& text) {
    std::set<std::string> found;
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i;
      while (end < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
        ++end;
      if (text[i] == '"') is_quoted = !is_quoted;
      if (end > i && !is_quoted && (i == 0 || text[i - 1] != ':')) found.insert(text.substr(i, end - i));
      i = end > i ? end : i + 1;
    }
    return found;
  }

  std::vector<one> all_{};
};

} // namespace playground
