#pragma once

#include <kanexpr/base/library_words.hpp>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace kanexpr::robots {

/// Keeps the letters, digits and single underscores of a name; replaces other characters by underscores.
inline std::string identifier_from(std::string_view name) {
  constexpr std::size_t most = 40; // leaves room for a prefix and a suffix in a name of 60 characters
  std::string plain;
  for (char c : name) {
    const bool taken = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (taken)
      plain += c;
    else if (!plain.empty() && plain.back() != '_')
      plain += '_';
  }
  if (plain.size() > most) plain = plain.substr(0, most / 2) + "_" + plain.substr(plain.size() - most / 2);
  plain.erase(std::unique(plain.begin(), plain.end(), [](char a, char b) { return a == '_' && b == '_'; }),
              plain.end());
  while (plain.ends_with('_')) plain.pop_back();
  return plain;
}

inline constexpr std::string_view reserved_words = R"(
alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class
compl concept const consteval constexpr constinit const_cast continue co_await co_return co_yield decltype
default delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline
int long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public
register reinterpret_cast requires return short signed sizeof static static_assert static_cast struct switch
template this thread_local throw true try typedef typeid typename union unsigned using virtual void volatile
wchar_t while xor xor_eq std kanexpr Eigen boost
)";

/// Whether a word is in a list of words, which are separated by spaces or line breaks.
inline bool is_in(std::string_view words, std::string_view word) {
  using base::library_words::next_of;
  for (std::string_view each = next_of(words); !each.empty(); each = next_of(words))
    if (each == word) return true;
  return false;
}

/// Whether a name may be the namespace of a model: not a C++ keyword, not a function of the C library, which
/// any header may declare, and not a namespace that a model uses.
inline bool is_valid_namespace(std::string_view name) {
  return !name.empty() && name[0] >= 'A' && name.find("__") == name.npos && identifier_from(name) == name &&
         !is_in(reserved_words, name) && !base::library_words::has(name);
}

/// Generates unique C++ identifiers.
class identifiers {
public:
  /// Returns the name of a type. It is capitalized because keywords and the names of the library are not.
  /// Entities that belong to the type are named after it with the suffixes `endings`.
  std::string type(std::string_view name, std::initializer_list<std::string_view> endings) {
    std::string plain = identifier_from(name);
    if (plain.empty()) plain = "Link";
    if (plain[0] >= '0' && plain[0] <= '9') plain = "Link_" + plain;
    if (plain[0] >= 'a' && plain[0] <= 'z') plain[0] = static_cast<char>(plain[0] - 'a' + 'A');
    return unused(plain, {}, endings);
  }
  /// Returns the name of a joint, whose symbols have the prefixes `beginnings`, such as "q_" and "u_".
  std::string joint(std::string_view name, std::initializer_list<std::string_view> beginnings) {
    const std::string plain = identifier_from(name);
    return unused(plain.empty() ? "joint" : plain, beginnings, {});
  }
  void reserve(std::string_view name) { used_.emplace(name); }

private:
  std::string unused(const std::string& wanted, std::initializer_list<std::string_view> beginnings,
                     std::initializer_list<std::string_view> endings) {
    const std::string begun = beginnings.size() == 0 ? wanted : std::string(*beginnings.begin()) + wanted;
    for (int& count = next_[begun];;) {
      ++count;
      const std::string name = count == 1 ? wanted : wanted + "_" + std::to_string(count);
      std::set<std::string> all;
      if (beginnings.size() == 0) all.insert(name);
      for (std::string_view b : beginnings) all.insert(std::string(b) + name);
      for (std::string_view e : endings) all.insert(name + std::string(e));
      bool free = true;
      for (const std::string& each : all) free = free && !used_.contains(each);
      if (!free) continue;
      used_.merge(all);
      return name;
    }
  }

  std::set<std::string> used_{};
  std::map<std::string, int> next_{}; ///< makes naming fast even for a thousand links with the same name
};

} // namespace kanexpr::robots
