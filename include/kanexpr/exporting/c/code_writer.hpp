#pragma once

#include <kanexpr/exporting/c/code_pieces.hpp>
#include <kanexpr/exporting/exported_system.hpp>
#include <kanexpr/exporting/text/identifiers.hpp>
#include <kanexpr/exporting/text/scalar.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// Writes the statements of a function in C, one operation per line. A long function is divided into pieces.
class code_writer {
public:
  /// `name` is the prefix of all names in the file.
  code_writer(const exported_function& of, const exported_system& system, std::string name,
              const scalar& number, const function_lengths& allowed)
      : of_(of), code_(of.code), system_(system), name_(std::move(name)), number_(number),
        pieces_(of.code, allowed), lines_(static_cast<std::size_t>(of.code.lines.size())) {
    names_.reserve_words();
    names_.reserve_words_of_mathematics();
    names_.reserve("t x p r a w");
    if (of.takes_step) names_.reserve("h");
    for (const exported_result& each : of.results) names_.reserve(each.name);
    if (pieces_.count() > 0) memory_ = names_.unique("memory");
  }

  const code_pieces& pieces() const { return pieces_; }
  /// The name of the array in which the pieces store values for each other.
  const std::string& memory() const { return memory_; }

  /// Returns the lines of a piece, which stores the values that other pieces need in `memory()`. The
  /// pieces must be written in their order.
  std::string piece(int index) {
    piece_ = index;
    angles_.clear();
    std::string text;
    for (int i = pieces_.begin(index); i < pieces_.end(index); ++i) text += line_and_store(i);
    return text;
  }

  /// Returns all lines, or only those that follow the pieces; `value` returns the names of their results.
  /// Each argument is read just before its first use: compilers keep that order and would spill arguments
  /// that are read earlier.
  std::string lines() {
    std::string text;
    piece_ = pieces_.count();
    if (piece_ == 0)
      for (int i = 0; i < code_.lines.size(); ++i) text += line_and_store(i);
    for (int each : code_.results) { // before writing results, which may alias arguments
      if (pieces_.place(each) != code_pieces::none)
        own(each).value = in_memory(each);
      else
        text += read(each);
    }
    return text;
  }

  const std::string& value(int line) const { return lines_[static_cast<std::size_t>(line)].value; }

private:
  using kind = lower::statement::kind;

  /// What is known of a line: the name of its value, and the text that reads it from an argument or from
  /// memory, unless the current piece has read it already.
  struct known_line {
    std::string value{}, reading{};
    int read_by = -1; ///< the last piece that has read it
  };
  known_line& own(int line) { return lines_[static_cast<std::size_t>(line)]; }

  std::string read(int line) {
    known_line& one = own(line);
    return std::exchange(one.read_by, piece_) == piece_ ? std::string() : one.reading;
  }

  std::string read_for(const lower::statement& s) {
    std::string text;
    lower::for_each_operand(code_, s, [&](int place) { text += read(place); });
    return text;
  }

  std::string in_memory(int line) const { return memory_ + '[' + std::to_string(pieces_.place(line)) + ']'; }

  std::string line_and_store(int i) {
    const std::string text = line(i);
    std::string all = read_for(code_.lines[i]) + text;
    if (pieces_.place(i) == code_pieces::none) return all;
    known_line& one = own(i);
    all += "  " + in_memory(i) + " = " + one.value + ";\n";
    if (code_.lines[i].is == kind::entry)
      one.value = in_memory(i);
    else
      one.reading = declared(one.value) + in_memory(i) + ";\n";
    one.read_by = piece_;
    return all;
  }

  std::string line(int i) {
    const lower::statement& s = code_.lines[i];
    std::string& value_of_line = own(i).value;
    if (s.is == kind::number) {
      value_of_line = number_of(code_.numbers[s.a]);
      return {};
    }
    if (s.is == kind::argument) {
      own(i).reading = argument(value_of_line, code_.arguments[s.a]);
      return {};
    }
    if (s.is == kind::choice) {
      value_of_line = next("v");
      return declared(value_of_line) + name_ + "_choose(" + value(s.by) + ", " + value(s.a) + ", " +
             value(s.b) + ");\n";
    }
    if (s.is == kind::solution) {
      value_of_line = next("v");
      return solution(value_of_line, code_.systems[s.a]);
    }
    if (s.is == kind::entry) {
      value_of_line = entry(value(s.a), code_.systems[code_.lines[s.a].a], s.b);
      return {};
    }
    if (s.op == symbolic::operation::sin || s.op == symbolic::operation::cos) return sine_or_cosine(i, s);
    value_of_line = next("v");
    return declared(value_of_line) + operation(s) + ";\n";
  }

  std::string next(const char* letter) { return names_.unique(letter + std::to_string(++count_)); }
  std::string declared(const std::string& value) const {
    return std::string("  const ") + number_.type() + ' ' + value + " = ";
  }

  /// An exact fraction is written as a quotient of two numbers of the scalar type.
  std::string number_of(const symbolic::number& n) const {
    if (number_.is_single) return number_.number(static_cast<double>(lower::number_as<float>(n)));
    return number_.number(lower::number_as<double>(n));
  }

  std::string argument(std::string& own, const lower::load& from) {
    using symbolic::symbol_kind;
    if (from.from == symbol_kind::time) {
      own = from.position == 0 ? "t" : "h";
      return {};
    }
    const auto place = static_cast<std::size_t>(from.position);
    if (from.from == symbol_kind::weight || from.from == symbol_kind::direction) {
      own = names_.unique("w" + std::to_string(place));
      return declared(own) + "w[" + std::to_string(place) + "];\n";
    }
    const auto [vector, names, first] = source_of(from.from);
    own = names_.unique(names[place] + (*vector == 'a' ? "_rate" : ""));
    return declared(own) + vector + '[' + std::to_string(first + place) + "];\n";
  }

  /// The vector argument that contains a kind of symbols, and the index of the first of them.
  struct source {
    const char* vector;
    const std::vector<std::string>& names;
    std::size_t first = 0;
  };
  source source_of(symbolic::symbol_kind of) const {
    const std::size_t coordinates = system_.coordinates.size();
    using enum symbolic::symbol_kind;
    switch (of) {
    case coordinate: return {"x", system_.coordinates};
    case speed: return {"x", system_.speeds, coordinates};
    case parameter: return {"p", system_.parameters};
    case input: return {"r", system_.inputs};
    case coordinate_rate: return {"a", system_.coordinates};
    default: return {"a", system_.speeds, of_.takes_all_rates ? coordinates : 0};
    }
  }

  /// Computes the sine and the cosine of an angle together when the first of them is needed.
  std::string sine_or_cosine(int i, const lower::statement& s) {
    const bool is_sine = s.op == symbolic::operation::sin;
    for (const angle& known : angles_)
      if (known.place == s.a) {
        own(i).value = is_sine ? known.sine : known.cosine;
        return {};
      }
    const angle one{s.a, next("s"), names_.unique("c" + std::to_string(count_))};
    angles_.push_back(one);
    own(i).value = is_sine ? one.sine : one.cosine;
    return std::string("  ") + number_.type() + ' ' + one.sine + ", " + one.cosine + ";\n  " + name_ +
           "_sine_and_cosine(" + value(s.a) + ", &" + one.sine + ", &" + one.cosine + ");\n";
  }

  static std::string entry(const std::string& array, const lower::solved_columns& of, int index) {
    return array + '[' + std::to_string(index / of.columns) + "][" + std::to_string(index % of.columns) + ']';
  }

  /// An array of the right-hand sides, and a loop over its columns that replaces them by the solution.
  std::string solution(const std::string& array, const lower::solved_columns& of) {
    std::string text = std::string("  ") + number_.type() + ' ' + array + '[' + std::to_string(of.order) +
                       "][" + std::to_string(of.columns) + "];\n";
    for (int i = 0; i < of.order * of.columns; ++i)
      if (of.is_given[i / of.columns] != 0)
        text += "  " + entry(array, of, i) + " = " +
                value(code_.operands[of.right_side(i / of.columns, i % of.columns)]) + ";\n";
    const std::string column = next("j");
    text += "  for (int " + column + " = 0; " + column + " < " + std::to_string(of.columns) + "; ++" +
            column + ") {\n";
    std::vector<std::string> rows;
    for (int i = 0; i < of.order; ++i) {
      rows.push_back(next("x"));
      const bool is_given = of.is_given[i] != 0;
      if (!is_given && of.steps.filled[i] == 0) continue;
      text += std::string("    ") + number_.type() + ' ' + rows.back();
      text += is_given ? " = " + at(array, i, column) + ";\n" : ";\n";
    }
    for (const numeric::column_step& s : of.steps.all) {
      const std::string &to = rows[static_cast<std::size_t>(s.to)],
                        &from = rows[static_cast<std::size_t>(s.from)],
                        &factor = value(code_.operands[of.operands + s.factor]);
      text.append("    ").append(to).append(" = ");
      if (s.is_pivot())
        text.append(from).append(" * ").append(factor).append(";\n");
      else if (s.fills)
        text.append("-(").append(factor).append(" * ").append(from).append(");\n");
      else
        text.append(to).append(" - ").append(factor).append(" * ").append(from).append(";\n");
    }
    for (int i = 0; i < of.order; ++i)
      if (of.steps.filled[i] != 0)
        text += "    " + at(array, i, column) + " = " + rows[static_cast<std::size_t>(i)] + ";\n";
    return text + "  }\n";
  }
  static std::string at(const std::string& array, int row, const std::string& column) {
    return array + '[' + std::to_string(row) + "][" + column + ']';
  }

  std::string operation(const lower::statement& s) const {
    using symbolic::form;
    const std::string &first = value(s.a), &second = value(s.b);
    switch (symbolic::form_of(s.op)) {
    case form::negate: return '-' + (first[0] == '-' ? '(' + first + ')' : first);
    case form::add: return first + " + " + second;
    case form::subtract: return first + " - " + second;
    case form::multiply: return first + " * " + second;
    case form::divide: return first + " / " + second;
    case form::power: return called("pow", first + ", " + second);
    case form::function: return called(s.op, first);
    case form::binary_function: return called(s.op, first + ", " + second);
    case form::leaf: // needs no line of code
    case form::selection:
    case form::list_operation: break; // written out by the caller; a call cannot be exported
    }
    return "";
  }
  std::string called(symbolic::operation op, const std::string& with) const {
    const symbolic::spelling_in_c& in_c = symbolic::spelling_of(op);
    if (*in_c.body != '\0') return name_ + '_' + symbolic::function_name(op) + '(' + with + ')';
    return called(*in_c.name != '\0' ? in_c.name : symbolic::function_name(op), with);
  }
  std::string called(const std::string& function, const std::string& with) const {
    return number_.function(function) + '(' + with + ')';
  }

  struct angle {
    int place;
    std::string sine, cosine;
  };

  const exported_function& of_;
  const lower::statements& code_;
  const exported_system& system_;
  std::string name_;
  scalar number_;
  identifiers names_{};
  code_pieces pieces_;
  std::vector<known_line> lines_;
  int piece_ = 0; ///< the one that is being written
  std::string memory_{};
  std::vector<angle> angles_{};
  int count_ = 0;
};

} // namespace kanexpr::exporting
