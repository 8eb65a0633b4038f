#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/exporting/c/code_writer.hpp>
#include <kanexpr/exporting/c/sine_and_cosine.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/exporting/text/names_in_c.hpp>
#include <kanexpr/mechanics/dynamics/singularity_check.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// The text around the functions in C, and the functions that they call.
namespace detail {

inline constexpr std::string_view c_header = template_text(
#include <kanexpr/exporting/c/header.h.in>
);

inline constexpr std::string_view c_source = template_text(
#include <kanexpr/exporting/c/source.c.in>
);

inline constexpr std::string_view c_helpers = template_text(
#include <kanexpr/exporting/c/helpers.c.in>
);

} // namespace detail

/// Writes NAME.h and NAME.c: a C99 function for each function of the system, with loops of fixed length,
/// without other branches and without allocating memory.
class c_file {
public:
  c_file(const exported_system& s, precision number, const function_lengths& allowed = {})
      : mapped_(names_in_c(s)), number_(number), allowed_(allowed) {}

  std::string header() const {
    std::string text = fill_template(
        detail::c_header,
        {{"title", title()},
         {"changed", renamed_symbols_comment()},
         {"name", name()},
         {"units",
          system().states_units ? "\n   Each comment is the unit of the entry; the time t is in s." : ""},
         {"places", places()}});
    for (const exported_function& f : system().functions) text += declaration(f);
    text += "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
    return text;
  }

  std::string source() const {
    std::string bodies;
    for (const exported_function& f : system().functions) bodies += definition(f);
    std::string text = fill_template(
        detail::c_source,
        {{"title", title()}, {"own_header", "#include \"" + name() + ".h\""}, {"name", name()}});
    text += helpers(bodies);
    return text + bodies;
  }

private:
  const exported_system& system() const { return mapped_.system; }
  const std::string& name() const { return mapped_.system.name; }

  std::string title() const {
    return "Equations of motion of " + name() + ", written by " + generator() + '.';
  }

  std::string renamed_symbols_comment() const {
    std::string text;
    for (const auto& [before, after] : mapped_.changed)
      text += "   " + in_comment(before) + " is called " + after + " here.\n";
    return text;
  }

  /// Returns the name without the characters that would end a comment.
  static std::string in_comment(const std::string& name) {
    std::string text = printable(name);
    for (std::size_t end; (end = text.find("*/")) != text.npos;) text.replace(end, 2, "* ");
    return text;
  }

  /// The indices and the counts as enumerators.
  std::string places() const {
    const exported_system& s = system();
    std::string text = "enum {\n";
    const auto add = [&](const std::string& what, std::size_t number, const std::string& unit = {}) {
      text += "  " + name() + '_' + what + " = " + std::to_string(number) + ',';
      text += unit.empty() ? "\n" : " /* " + unit + " */\n";
    };
    const auto add_all = [&](const std::vector<std::string>& names, const std::vector<exported_unit>& units) {
      for (std::size_t i = 0; i < names.size(); ++i) add(names[i], i, units.empty() ? "" : units[i].text);
    };
    add_all(s.states(), s.units_of_states);
    add_all(s.parameters, s.units_of_parameters);
    add_all(s.inputs, s.units_of_inputs);
    add("coordinates", s.coordinates.size());
    add("speeds", s.speeds.size());
    add("states", s.coordinates.size() + s.speeds.size());
    add("parameters", s.parameters.size());
    add("inputs", s.inputs.size());
    return text.erase(text.size() - 2, 1) + "};\n";
  }

  std::string header_comment(const exported_function& f) const {
    const auto counted = [](int n, const char* one, const char* many) {
      return std::to_string(n) + ' ' + (n == 1 ? one : many);
    };
    const symbolic::cost& c = f.cost;
    std::string text = "\n/* " + counted(c.multiplications, "multiplication", "multiplications") + ", " +
                       counted(c.additions, "addition", "additions") + ", " +
                       counted(c.divisions, "division", "divisions") + ", " +
                       counted(c.trigonometric, "sine and cosine", "sines and cosines") + " or the like, " +
                       counted(c.other, "other function", "other functions") + '.';
    for (const exported_result& each : f.results) {
      text += "\n   " + each.name;
      if (each.is_sparse)
        text += ": " + std::to_string(each.entries()) + " of " + std::to_string(each.rows) + " by " +
                std::to_string(each.columns) + ", column-major; the other entries are zero";
      else if (each.columns > 1)
        text += ": " + std::to_string(each.rows) + " by " + std::to_string(each.columns) + ", row-major";
      else
        text += ": " + std::to_string(each.rows);
      for (std::size_t i = 0; i < each.row_symbols.size(); ++i)
        text += (i == 0 ? each.columns > 1 ? "; the rows belong to " : ", of " : ", ") + each.row_symbols[i];
      text += units_of_entries(each) + '.';
    }
    const std::vector<std::string> causes = f.causes();
    for (std::size_t i = 0; i < causes.size(); ++i)
      text += "\n   Bit " + std::to_string(i) + " of the status: " + causes[i] + '.';
    if (causes.empty()) text += "\n   The status is always 0: there are no singularities.";
    return text + " */\n";
  }

  /// "; in kg.m2", or the units of all entries if they differ, row by row.
  static std::string units_of_entries(const exported_result& of) {
    const auto text_of = [](const exported_unit& each) { return each.is_known() ? each.text : "?"; };
    if (of.units.empty()) return {};
    const bool are_equal = std::ranges::all_of(of.units, [&](const auto& u) { return u == of.units[0]; });
    return "; in " + (are_equal ? text_of(of.units[0]) : joined(of.units, ", ", text_of));
  }

  /// The arguments that precede the results of a function.
  static std::vector<std::string> arguments(const exported_function& f) {
    std::vector<std::string> all{"t", "x", "p", "r"};
    if (f.takes_step) all.insert(all.begin() + 2, "h");
    if (f.takes_rates || f.takes_all_rates) all.emplace_back("a");
    if (f.weights > 0) all.emplace_back("w");
    return all;
  }

  std::string declared_arguments(const exported_function& f) const {
    const std::string number = number_.type();
    return joined(arguments(f), ", ", [&](const std::string& each) {
      return each == "t" || each == "h" ? number + ' ' + each : "const " + number + " *" + each;
    });
  }

  std::string signature(const exported_function& f) const {
    std::string text = name() + "_FUNCTION unsigned long long " + name() + '_' + f.name + '(';
    text += declared_arguments(f);
    for (const exported_result& each : f.results)
      text += std::string(", ") + number_.type() + " *" + each.name;
    return text + ')';
  }

  std::string declaration(const exported_function& f) const {
    std::string text = header_comment(f) + "enum {\n";
    for (const exported_result& each : f.results) {
      const std::string begin =
          "  " + name() + '_' + (each.name == f.name ? "" : f.name + '_') + each.name + '_';
      text += begin + "rows = " + std::to_string(each.rows) + ",\n";
      text += begin + "columns = " + std::to_string(each.columns) + ",\n";
      if (each.is_sparse) text += begin + "entries = " + std::to_string(each.entries()) + ",\n";
    }
    text += "  " + name() + '_' + f.name + "_checks = " + std::to_string(f.causes().size()) + "\n};\n";
    text += signature(f) + ";\n";
    if (!f.checks.empty())
      text += "extern const char *const " + name() + '_' + f.name + "_causes[" +
              std::to_string(f.causes().size()) + "];\n";
    return text;
  }

  static std::string unused(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& each : names) text += "  (void)" + each + ";\n";
    return text;
  }

  std::string name_of_piece(const exported_function& f, int index) const {
    return name() + '_' + f.name + "_piece_" + std::to_string(index + 1);
  }

  std::string piece(const exported_function& f, code_writer& writer, int index) const {
    std::vector<std::string> all = arguments(f);
    all.push_back(writer.memory());
    return '\n' + name() + "_PIECE void " + name_of_piece(f, index) + '(' + declared_arguments(f) + ", " +
           number_.type() + " *" + writer.memory() + ") {\n" + writer.piece(index) + unused(all) + "}\n";
  }

  std::string calls_of_pieces(const exported_function& f, const code_writer& writer) const {
    const code_pieces& pieces = writer.pieces();
    if (pieces.count() == 0) return {};
    std::string text = std::string("  ") + number_.type() + ' ' + writer.memory() + '[' +
                       std::to_string((std::max)(pieces.places(), 1)) + "];\n";
    for (int i = 0; i < pieces.count(); ++i)
      text += "  " + name_of_piece(f, i) + '(' +
              joined(arguments(f), ", ", [](const std::string& each) { return each; }) + ", " +
              writer.memory() + ");\n";
    return text;
  }

  std::string definition(const exported_function& f) const {
    code_writer writer(f, system(), name(), number_, allowed_);
    std::string text;
    for (int i = 0; i < writer.pieces().count(); ++i) text += piece(f, writer, i);
    text += '\n' + signature(f) + " {\n" + calls_of_pieces(f, writer) + writer.lines() + unused(arguments(f));
    for (const exported_result& each : f.results)
      if (each.entries() == 0) text += "  (void)" + each.name + ";\n";
    for (const exported_result& each : f.results)
      for (int i = 0; i < each.entries(); ++i)
        text += "  " + each.name + '[' + std::to_string(i) +
                "] = " + writer.value(f.code.results[each.first + i]) + ";\n";
    text += "  return " + checked(f, writer) + ";\n}\n";
    const std::vector<std::string> causes = f.causes();
    if (!causes.empty()) {
      text += "const char *const " + name() + '_' + f.name + "_causes[" + std::to_string(causes.size()) +
              "] = {\n";
      text += joined(causes, ",\n", [](const std::string& each) { return "  \"" + each + '"'; }) + "\n};\n";
    }
    return text;
  }

  std::string checked(const exported_function& f, const code_writer& writer) const {
    std::vector<std::string> bits;
    const std::vector<std::string> causes = f.causes();
    for (std::size_t i = 0; i < f.checks.size(); ++i) {
      const exported_check& one = f.checks[i];
      const auto bit = std::find(causes.begin(), causes.end(), one.cause) - causes.begin();
      const std::string shift = bit == 0 ? "" : " << " + std::to_string(bit);
      if (one.watches_results) {
        for (const exported_result& each : f.results)
          if (const std::string watched = watched_entries(f, each); !watched.empty()) {
            bits.push_back(name() + "_is_any_infinite(");
            bits.back().append(watched).append(")").append(shift);
          }
        continue;
      }
      const int place = f.entries() + 2 * static_cast<int>(i);
      const std::string measure = writer.value(f.code.results[place]),
                        scale = writer.value(f.code.results[place + 1]);
      std::string asked = name();
      asked += one.is_finiteness_check ? "_is_infinite("
               : one.is_order_check    ? "_is_not_above("
                                       : "_is_singular(";
      asked += measure;
      if (!one.is_finiteness_check) asked.append(", ").append(scale);
      asked.append(")").append(shift);
      if (std::find(bits.begin(), bits.end(), asked) == bits.end()) bits.push_back(std::move(asked));
    }
    return bits.empty() ? "0" : joined(bits, " | ", [](const std::string& each) { return each; });
  }

  /// "A + 7, 7", the entries of a result from the first to the last that is not a number; empty if all are.
  static std::string watched_entries(const exported_function& f, const exported_result& of) {
    const auto is_number = [&](int i) {
      return f.code.lines[f.code.results[of.first + i]].is == lower::statement::kind::number;
    };
    int begin = 0, end = of.entries();
    while (begin < end && is_number(begin)) ++begin;
    while (begin < end && is_number(end - 1)) --end;
    if (begin == end) return {};
    return of.name + (begin == 0 ? "" : " + " + std::to_string(begin)) + ", " + std::to_string(end - begin);
  }

  /// The helper functions that the bodies call.
  std::string helpers(const std::string& bodies) const {
    const auto calls = [&](const std::string& what) {
      return bodies.find(name() + '_' + what + '(') != bodies.npos;
    };
    const double least = number_.is_single ? base::least_singularity_measure<float>()
                                           : base::least_singularity_measure<double>();
    const auto in_text = [&](std::string_view text) {
      return fill_template(text, {{"name", name()},
                                  {"number", number_.type()},
                                  {"bits", number_.bits()},
                                  {"least", number_.number(least)},
                                  {"fabs", number_.function("fabs")},
                                  {"one", number_.number(1)},
                                  {"zero", number_.number(0)},
                                  {"f", number_.function("")},
                                  {"pi", number_.number(std::numbers::pi)},
                                  {"turn", number_.number(2 * std::numbers::pi)},
                                  {"exponent", number_.exponent_bits()},
                                  {"unit", number_.unit_of_exponent()},
                                  {"last_bit", number_.last_bit()}});
    };
    std::string functions;
    for (const symbolic::operation each : written_functions())
      if (calls(symbolic::function_name(each)))
        functions +=
            in_text(std::string("\n@name@_INLINE @number@ @name@_") + symbolic::function_name(each) +
                    (symbolic::is_binary(each) ? "(@number@ x, @number@ y) {\n" : "(@number@ x) {\n") +
                    symbolic::spelling_of(each).body + "}\n");
    const auto part = [&](const char* called) { return in_text(template_part(detail::c_helpers, called)); };
    const bool turns = calls("sine_and_cosine"),
               chooses = calls("choose") || functions.find("_choose(") != functions.npos;
    std::string text;
    if (bodies.find(name() + "_PIECE ") != bodies.npos) text += part("piece");
    if (turns || chooses || calls("is_infinite") || calls("is_any_infinite")) text += part("bits");
    if (turns) text += sine_and_cosine_in_c(name(), number_);
    if (chooses) text += part("choose");
    text += functions;
    for (const char* check : {"is_singular", "is_not_above", "is_infinite", "is_any_infinite"})
      if (calls(check)) text += part(check);
    return text;
  }

  system_with_c_names mapped_;
  scalar number_;
  function_lengths allowed_;
};

/// Reports a number that is out of the range of the scalar type; empty if there is none.
inline std::string mistake_of_numbers(const exported_system& s, precision number) {
  for (const exported_function& f : s.functions)
    for (const symbolic::number& n : f.code.numbers)
      if (!numeric::is_finite(number == precision::single_precision
                                  ? static_cast<double>(lower::number_as<float>(n))
                                  : lower::number_as<double>(n)))
        return "function " + f.name + " contains a number that " + scalar(number).type() +
               " cannot represent";
  return {};
}

} // namespace kanexpr::exporting
