#pragma once

#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/limits.hpp>
#include <kanexpr/flexible/sid/document.hpp>
#include <kanexpr/flexible/sid/line.hpp>
#include <kanexpr/flexible/sid/numbers.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::flexible::sid {

/// Reads the text of a file with standard input data. The programs that write such files differ in details:
/// keywords in upper or lower case, `frame` or `new frame`, the text before `part`, and the notation of
/// numbers. All of these forms are accepted.
class reader {
public:
  sid::document document{};

  reader(std::string_view text, file_report& report) : lines_(text), report_(report) {}

  /// Whether the text is well formed; otherwise, the report contains the first mistake.
  bool read() {
    while (next() && !line_.is("part")) {
    }
    if (!line_.number) return report_.fail("there is no line part, so the file has no standard input data");
    if (!next()) return fail_at_end("new modal");
    if (!line_.is("new modal")) return fail_here("new modal");
    if (!read_body()) return false;
    if (!next()) return fail_at_end("end part");
    return is_same_word(line_.closed(), "part") || fail_here("end part");
  }

private:
  static constexpr std::array<std::string_view, 4> node_series{"origin", "phi", "psi", "AP"};

  bool next() {
    line_ = lines_.next();
    return line_.number != 0;
  }
  bool fail_here(const std::string& expected) {
    return report_.fail(line_.number, "expected " + expected + ", got " + printable(line_.text));
  }
  bool fail_at_end(const std::string& expected) {
    return report_.fail(lines_.last(), "the file ends here; expected " + expected);
  }
  bool closes(std::string_view word) const { return is_same_word(line_.closed(), word); }

  bool read_body() {
    while (next()) {
      if (closes("modal")) return true;
      if (line_.is("refmod")) {
        if (!read_reference()) return false;
      } else if (line_.is("frame") || line_.is("new frame")) {
        if (!read_nodes()) return false;
      } else if (const std::size_t matrix = place_in(matrix_names); matrix < matrix_names.size()) {
        if (!read_series(document.matrices[matrix])) return false;
      } else if (!skip_section("end modal or a section of the body such as refmod, frame, mdCM or J")) {
        return false;
      }
    }
    return fail_at_end("end modal");
  }

  /// The place of the keyword of this line in a list of names; the length of the list if it is not there.
  template <std::size_t count>
  std::size_t place_in(const std::array<std::string_view, count>& names) const {
    std::size_t i = 0;
    while (i < count && !line_.is(names[i])) ++i;
    return i;
  }

  /// Skips a section with an unknown name, to its end.
  bool skip_section(const std::string& expected) {
    const std::string name(line_.key);
    const int begun = line_.number;
    if (line_.text.find('=') != line_.text.npos || !line_.closed().empty()) return fail_here(expected);
    while (next())
      if (closes(name)) {
        report_.note(begun, "the section " + printable(name) + " is ignored");
        return true;
      }
    return report_.fail(begun, "expected " + expected + ", got " + printable(name));
  }

  bool read_reference() {
    while (next()) {
      if (closes("refmod")) return true;
      if (line_.is("mass")) {
        document.mass_line = line_.number;
        if (!read_number(document.mass, "the mass")) return false;
      } else if (line_.is("nelastq")) {
        document.amplitudes_line = line_.number;
        if (!read_count(document.amplitudes, "the number of amplitudes nelastq")) return false;
        if (document.amplitudes > most_amplitudes)
          return report_.fail(line_.number, "the body has " + std::to_string(document.amplitudes) +
                                                " amplitudes; at most " + std::to_string(most_amplitudes) +
                                                " are supported");
      } else if (!is_same_word(line_.key.substr(0, 7), "ielastq")) {
        return fail_here("mass, nelastq, ielastq or end refmod");
      }
    }
    return fail_at_end("end refmod");
  }

  bool read_nodes() {
    while (next()) {
      if (closes("frame")) return true;
      if (!line_.is("new node")) return fail_here("new node or end frame");
      if (!read_node()) return false;
    }
    return fail_at_end("end frame");
  }

  bool read_node() {
    node& read = document.nodes.emplace_back();
    read.line = line_.number;
    read.called = std::string(line_.value);
    if (read.called.empty()) return fail_here("the number or name of the node after new node =");
    const std::array<series*, 4> parts{&read.origin, &read.phi, &read.psi, &read.orientation};
    while (next()) {
      if (closes("node")) return true;
      if (line_.is("rframe")) continue;
      const std::size_t part = place_in(node_series);
      if (part < node_series.size()) {
        if (!read_series(*parts[part])) return false;
      } else if (!line_.is("sigma") ? !skip_section("origin, phi, psi, AP or end node") : !skip_stresses()) {
        return false;
      }
    }
    return fail_at_end("end node");
  }

  /// Skips the stresses at a node, which do not enter the equations.
  bool skip_stresses() {
    while (next())
      if (closes("sigma")) return true;
    return fail_at_end("end sigma");
  }

  bool read_series(series& into) {
    if (into.is_given())
      return report_.fail(line_.number, "there is a second " + std::string(into.called) +
                                            "; the first one begins in line " + std::to_string(into.line));
    into.line = line_.number;
    while (next()) {
      if (closes(into.called)) return true;
      if (!read_part_of(into)) return false;
    }
    return fail_at_end("end " + std::string(into.called));
  }

  bool read_part_of(series& into) {
    const std::string of = " of " + std::string(into.called);
    int stored = 0, ignored = 0;
    if (line_.is("order")) {
      if (!read_count(into.order, "the order" + of)) return false;
      return into.order < 3 ||
             report_.fail(line_.number,
                          "the order" + of + " is " + std::to_string(into.order) + "; expected 0, 1 or 2");
    }
    if (line_.is("nrow")) return read_count(into.rows, "the number of rows" + of);
    if (line_.is("ncol")) return read_count(into.columns, "the number of columns" + of);
    if (line_.is("nq")) return read_count(into.amplitudes, "the number of amplitudes" + of);
    if (line_.is("nqn")) return read_count(ignored, "nqn" + of);
    if (line_.is("structure")) {
      if (!read_count(stored, "the structure" + of)) return false;
      if (stored > 4)
        return report_.fail(line_.number,
                            "the structure" + of + " is " + std::to_string(stored) + "; expected 0 to 4");
      into.structure = static_cast<sid::structure>(stored);
      return true;
    }
    if (is_same_word(line_.key.substr(0, 2), "m0")) return read_entry(into.m0, 2, of);
    if (is_same_word(line_.key.substr(0, 2), "m1")) return read_entry(into.m1, 3, of);
    if (is_same_word(line_.key.substr(0, 2), "m2")) return read_entry(into.m2, 4, of);
    if (is_same_word(line_.key.substr(0, 2), "mn"))
      return report_.fail(line_.number,
                          "mn" + of +
                              " counts products of amplitudes in an order that standard input "
                              "data do not define; write m2 with the indices of both amplitudes");
    return fail_here("order, nrow, ncol, nq, nqn, structure, m0, m1, m2 or end " + std::string(into.called));
  }

  bool read_entry(std::vector<entry>& into, int indices, const std::string& of) {
    entry read;
    read.line = line_.number;
    std::string_view list = trimmed(line_.key.substr(2));
    const bool enclosed = list.starts_with('(') && list.ends_with(')');
    if (enclosed) list = list.substr(1, list.size() - 2);
    const std::array<int*, 4> each{&read.first, &read.second, &read.third, &read.fourth};
    static constexpr std::array<const char*, 5> forms{"", "", "m0(row, column)", "m1 with three indices",
                                                      "m2 with four indices"};
    for (int i = 0; i < indices; ++i) {
      const std::size_t comma = list.find(',');
      const std::optional<int> index = count_in(trimmed(list.substr(0, comma)));
      const bool is_last = i + 1 == indices;
      if (!enclosed || !index || *index == 0 || (comma == list.npos) != is_last)
        return fail_here(forms[static_cast<std::size_t>(indices)] + of + ", counted from 1");
      *each[static_cast<std::size_t>(i)] = *index;
      if (!is_last) list = list.substr(comma + 1);
    }
    if (!read_number(read.value, std::string(line_.key) + of)) return false;
    into.push_back(read);
    return true;
  }

  bool read_number(double& into, const std::string& what) {
    const std::optional<double> value = number_in(line_.value);
    if (!value)
      return report_.fail(line_.number,
                          printable(what) + ": expected a finite number, got " + quoted(line_.value));
    into = *value;
    return true;
  }
  bool read_count(int& into, const std::string& what) {
    const std::optional<int> value = count_in(line_.value);
    if (!value) return report_.fail(line_.number, what + ": expected a count, got " + quoted(line_.value));
    into = *value;
    return true;
  }
  static std::string quoted(std::string_view text) {
    return text.empty() ? "nothing" : "\"" + printable(text, 40) + "\"";
  }

  lines lines_;
  file_report& report_;
  line line_{};
};

} // namespace kanexpr::flexible::sid
