#pragma once

#include <kanexpr/export/write_c.hpp>
#include <kanexpr/export/write_casadi.hpp>
#include <kanexpr/export/write_fmu.hpp>

#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// An export request in the form in which the command kanexpr-export passes it on: a folder, a name, and
/// options as strings.
class by_words {
public:
  /// `others` are functions that a string cannot specify.
  explicit by_words(const std::vector<std::string>& words, const std::vector<wanted_function>& others = {}) {
    if (words.size() < 2) {
      mistake_ = "a folder and a name are required";
      return;
    }
    folder_ = words[0], name_ = words[1];
    for (std::size_t i = 2; i < words.size() && mistake_.empty(); ++i) take(words[i]);
    functions_.insert(functions_.end(), others.begin(), others.end());
    if (!functions_.empty()) chosen_.functions = functions_;
    look_at_format();
  }

  /// The first mistake in the request; empty if there is none.
  const std::string& mistake() const { return mistake_; }

  outcome write(runtime::staged_derivation& derivation) const {
    if (!mistake_.empty()) return outcome(mistake_);
    if (format_ == "casadi") return detail::write_casadi(derivation, folder_, name_, {chosen_.bound});
    if (format_ == "fmi") return write_fmu(derivation);
    return detail::write_c(exporter(name_, derivation, chosen_).run(), folder_, chosen_);
  }

private:
  outcome write_fmu(runtime::staged_derivation& derivation) const {
    fmu_options all{.outputs = functions_, .bound = chosen_.bound, .start = start_};
    if (step_) all.step = *step_;
    if (compiler_) all.compiler = *compiler_;
    written_fmu written = detail::write_fmu(derivation, folder_, name_, all);
    if (!written.note().empty()) std::fprintf(stderr, "kanexpr-export: note: %s\n", written.note().c_str());
    return written;
  }

  void take(std::string_view word) {
    const auto begins = [&](std::string_view with) {
      if (!word.starts_with(with)) return false;
      word.remove_prefix(with.size());
      return true;
    };
    if (begins("format="))
      format_ = word;
    else if (begins("scalar="))
      set_scalar(word);
    else if (begins("bind=")) {
      if (const auto [name, value] = assignment(word, "parameter"); value)
        chosen_.bound.push_back({name, *value});
    } else if (begins("start=")) {
      if (const auto [name, value] = assignment(word, "symbol"); value) start_.push_back({name, *value});
    } else if (begins("step=")) {
      if (step_ = number(word); !step_) mistake_ = std::string(word) + " is not a valid step length";
    } else if (begins("compiler="))
      compiler_ = word;
    else if (begins("results="))
      functions_.push_back(results(word));
    else if (word == "python")
      chosen_.with_python = true;
    else if (word == "cpp")
      chosen_.with_cpp = true;
    else
      mistake_ = std::string(word) + " is not an option";
  }

  /// Checks that the format supports the options.
  void look_at_format() {
    if (!mistake_.empty()) return;
    const bool is_c = format_ == "c", is_fmi = format_ == "fmi";
    if (!is_c && !is_fmi && format_ != "casadi")
      mistake_ = "unknown format " + format_ + "; expected c, casadi or fmi";
    else if (!is_c && chosen_.number == precision::single_precision)
      mistake_ = "the format " + format_ + " supports only double precision";
    else if (!is_c && (chosen_.with_python || chosen_.with_cpp))
      mistake_ = "files for Python and C++ require the format c";
    else if (!is_c && !is_fmi && !functions_.empty())
      mistake_ = "the format " + format_ + " exports the rates of the state and no other results";
    else if (!is_fmi && (!start_.empty() || step_))
      mistake_ = "start values and a step require the format fmi";
  }

  void set_scalar(std::string_view type) {
    if (type == "float")
      chosen_.number = precision::single_precision;
    else if (type != "double")
      mistake_ = "the scalar type must be double or float, not " + std::string(type);
  }

  static std::optional<double> number(std::string_view digits) {
    double value = 0;
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || failed != std::errc() || end != digits.data() + digits.size()) return {};
    return value;
  }

  struct assigned {
    std::string name{};
    std::optional<double> value{};
  };

  assigned assignment(std::string_view text, const char* to_what) {
    const std::size_t equals = text.find('=');
    assigned found;
    if (equals != text.npos && equals != 0)
      found = {std::string(text.substr(0, equals)), number(text.substr(equals + 1))};
    if (!found.value) mistake_ = std::string(text) + " is not of the form " + to_what + "=number";
    return found;
  }

  std::filesystem::path folder_{};
  std::string name_{}, format_ = "c", mistake_{};
  c_options chosen_{};
  std::vector<wanted_function> functions_{};
  std::vector<named_value> start_{};
  std::optional<double> step_{};
  std::optional<std::string> compiler_{};
};

/// The main function of the program that kanexpr-export compiles together with a model.
template <class System>
int write_by_words(int count, const char* const* arguments, const std::vector<wanted_function>& expressions) {
  const by_words given(std::vector<std::string>(arguments + 1, arguments + count), expressions);
  runtime::staged_derivation derivation([] { return derive<System>(); });
  const outcome written = given.write(derivation);
  if (!written) std::fprintf(stderr, "kanexpr-export: %s\n", written.cause().c_str());
  return written ? 0 : 1;
}

} // namespace kanexpr::exporting
