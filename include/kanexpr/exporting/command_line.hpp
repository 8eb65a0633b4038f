#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/exporting/format.hpp>

#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// The arguments with which kanexpr-export calls a program that exports a model: a folder, a name, and
/// options.
class command_line {
public:
  /// `others` are functions that cannot be specified by strings.
  command_line(const export_format& format, const std::vector<std::string>& arguments,
               const std::vector<requested_function>& others = {})
      : format_(format) {
    if (arguments.size() < 2) {
      cause_ = "a folder and a name are required";
      return;
    }
    chosen_.folder = arguments[0], chosen_.name = arguments[1];
    for (std::size_t i = 2; i < arguments.size() && cause_.empty(); ++i) parse_option(arguments[i]);
    chosen_.functions.insert(chosen_.functions.end(), others.begin(), others.end());
    if (cause_.empty()) check_format();
  }

  /// The first mistake in the arguments; empty if there is none.
  const std::string& cause() const { return cause_; }

  outcome write(runtime::staged_derivation& derivation) const {
    return cause_.empty() ? format_.write(derivation, chosen_) : outcome(cause_);
  }

private:
  void parse_option(std::string_view option) {
    const auto begins = [&](std::string_view with) {
      if (!option.starts_with(with)) return false;
      option.remove_prefix(with.size());
      return true;
    };
    if (begins("scalar="))
      set_scalar(option);
    else if (begins("bind="))
      add_assignment(option, "parameter", chosen_.bound);
    else if (begins("start="))
      add_assignment(option, "symbol", chosen_.start);
    else if (begins("step=")) {
      if (chosen_.step = number(option); !chosen_.step)
        cause_ = std::string(option) + " is not a valid step length";
    } else if (begins("compiler="))
      chosen_.compiler = option;
    else if (begins("results="))
      chosen_.functions.push_back(results(option));
    else if (option == "python")
      chosen_.with_python = true;
    else if (option == "cpp")
      chosen_.with_cpp = true;
    else
      cause_ = std::string(option) + " is not an option";
  }

  /// Checks that the format supports the options.
  void check_format() {
    const std::string name(format_.name);
    if (!format_.has_float && chosen_.number == precision::single_precision)
      cause_ = "the format " + name + " supports only double precision";
    else if (!format_.has_callers && (chosen_.with_python || chosen_.with_cpp))
      cause_ = "files for Python and C++ require the format c";
    else if (!format_.has_functions && !chosen_.functions.empty())
      cause_ = "the format " + name + " exports the rates of the state and no other results";
    else if (!format_.has_simulation && (!chosen_.start.empty() || chosen_.step))
      cause_ = "start values and a step require the format fmi";
  }

  void set_scalar(std::string_view type) {
    if (type == "float")
      chosen_.number = precision::single_precision;
    else if (type != "double")
      cause_ = "the scalar type must be double or float, not " + std::string(type);
  }

  static std::optional<double> number(std::string_view digits) {
    double value = 0;
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || failed != std::errc() || end != digits.data() + digits.size()) return {};
    return value;
  }

  /// Adds the value of `name=number`.
  template <class Values>
  void add_assignment(std::string_view text, const char* kind, Values& to) {
    const std::size_t equals = text.find('=');
    std::optional<double> value;
    if (equals != text.npos && equals != 0) value = number(text.substr(equals + 1));
    if (value)
      to.push_back({std::string(text.substr(0, equals)), *value});
    else
      cause_ = std::string(text) + " is not of the form " + kind + "=number";
  }

  const export_format& format_;
  std::string cause_{};
  export_options chosen_{};
};

/// The main function of the program that kanexpr-export compiles together with a model.
template <class System>
int run_command_line(const export_format& format, int count, const char* const* arguments,
                     const std::vector<requested_function>& expressions) {
  const command_line given(format, {arguments + 1, arguments + count}, expressions);
  runtime::staged_derivation derivation([] { return derive<System>(); });
  const outcome written = given.write(derivation);
  if (!written) std::fprintf(stderr, "kanexpr-export: %s\n", written.cause().c_str());
  return written ? 0 : 1;
}

} // namespace kanexpr::exporting
