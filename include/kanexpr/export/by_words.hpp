#pragma once

#include <kanexpr/export/write_c.hpp>

#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// What the command kanexpr-export hands to what writes: a folder, a name, and options as words.
struct by_words {
  std::filesystem::path folder{};
  std::string name{};
  c_options chosen{};
  std::string mistake{};

  /// With functions that no word can tell.
  explicit by_words(const std::vector<std::string>& words, const std::vector<wanted_function>& others = {}) {
    if (words.size() < 2) {
      mistake = "a folder and a name are to be given";
      return;
    }
    folder = words[0], name = words[1];
    for (std::size_t i = 2; i < words.size() && mistake.empty(); ++i) take(words[i]);
    functions_.insert(functions_.end(), others.begin(), others.end());
    if (!functions_.empty()) chosen.functions = std::move(functions_);
  }

private:
  void take(std::string_view word) {
    const auto begins = [&](std::string_view with) {
      if (!word.starts_with(with)) return false;
      word.remove_prefix(with.size());
      return true;
    };
    if (begins("scalar="))
      set_scalar(word);
    else if (begins("bind="))
      bind(word);
    else if (begins("results="))
      functions_.push_back(results(word));
    else if (word == "python")
      chosen.with_python = true;
    else if (word == "cpp")
      chosen.with_cpp = true;
    else
      mistake = std::string(word) + " is no option";
  }

  void set_scalar(std::string_view number) {
    if (number == "float")
      chosen.number = precision::single_precision;
    else if (number != "double")
      mistake = "a scalar is double or float, not " + std::string(number);
  }

  void bind(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view digits = equals == text.npos ? "" : text.substr(equals + 1);
    double value = 0;
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (equals == 0 || digits.empty() || failed != std::errc() || end != digits.data() + digits.size())
      mistake = std::string(text) + " is not parameter=number";
    else
      chosen.bound.push_back({std::string(text.substr(0, equals)), value});
  }

  std::vector<wanted_function> functions_{};
};

/// What the program does that kanexpr-export compiles with a model.
template <class System>
int write_by_words(int count, const char* const* arguments, const std::vector<wanted_function>& expressions) {
  const by_words given(std::vector<std::string>(arguments + 1, arguments + count), expressions);
  const outcome written = given.mistake.empty() ? write_c<System>(given.folder, given.name, given.chosen)
                                                : outcome(given.mistake);
  if (!written) std::fprintf(stderr, "kanexpr-export: %s\n", written.cause().c_str());
  return written ? 0 : 1;
}

} // namespace kanexpr::exporting
