#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>
#include <kanexpr/robots/cpp.hpp>

#include <string>
#include <string_view>

namespace kanexpr::flexible {

/// Writes a header with the numbers of a flexible body: a constant `data` in a namespace, which reads back as
/// the same numbers.
class header_writer {
public:
  explicit header_writer(const mechanics::flexible_data& data) : data_(data) {}

  std::string write(const std::string& name, std::string_view file) const {
    const std::string n = std::to_string(data_.amplitudes), nodes = std::to_string(data_.nodes.size());
    std::string text =
        "#pragma once\n\n// Written by kanexpr-flexible-body from " + robots::cpp::comment(file) + ".\n\n" +
        robots::cpp::include("kanexpr/describe/flexible/flexible_body_data.hpp") + "\nnamespace " + name +
        " {\n\ninline constexpr kanexpr::flexible_body_data<" + n + ", " + nodes + counts_of_terms() +
        "> data{\n    .mass = " + robots::cpp::number(data_.mass);
    text += member("first_moment", data_.first_moment.coefficients);
    text += member("inertia", data_.inertia.coefficients);
    text += member("angular", data_.angular.coefficients);
    text += member("modal_mass", data_.modal_mass);
    text += member("stiffness", data_.stiffness);
    text += member("damping", data_.damping);
    text += member("preload", data_.preload);
    text += terms("elastic_terms", data_.elastic_terms,
                  [](const mechanics::elastic_term&) { return std::string(); });
    text += terms("damping_terms", data_.damping_terms, [](const mechanics::damping_term& t) {
      return ", .row = " + std::to_string(t.row) + ", .column = " + std::to_string(t.column);
    });
    if (!data_.nodes.empty()) text += ",\n    .nodes = {" + nodes_text() + "}";
    return text + "};\n\n} // namespace " + name + "\n";
  }

private:
  static std::string list(const base::sequence<double>& numbers, std::size_t indent) {
    std::string text = "{";
    std::size_t column = indent;
    for (int i = 0; i < numbers.size(); ++i) {
      const std::string number = robots::cpp::number(numbers[i]);
      const bool breaks = column + number.size() + 2 > robots::cpp::columns;
      text += i == 0 ? "" : breaks ? ",\n" + std::string(indent, ' ') : ", ";
      column = breaks ? indent + number.size() : column + number.size() + 2;
      text += number;
    }
    return text + "}";
  }
  static std::string member(const std::string& name, const base::sequence<double>& numbers) {
    const std::string before = "    ." + name + " = ";
    return ",\n" + before + list(numbers, before.size() + 1);
  }
  std::string counts_of_terms() const {
    const int elastic = data_.elastic_terms.size(), damping = data_.damping_terms.size();
    if (elastic == 0 && damping == 0) return {};
    return ", " + std::to_string(elastic) + (damping == 0 ? "" : ", " + std::to_string(damping));
  }
  /// A list of terms; `place` writes their members between the coefficient and the amplitudes.
  template <class Term, class Place>
  static std::string terms(const std::string& name, const base::sequence<Term>& all, const Place& place) {
    if (all.empty()) return {};
    std::string text;
    for (const Term& t : all) {
      std::string amplitudes;
      for (const int k : t.amplitudes) amplitudes += (amplitudes.empty() ? "" : ", ") + std::to_string(k);
      text += (text.empty() ? "{.coefficient = " : ",\n        {.coefficient = ") +
              robots::cpp::number(t.coefficient);
      text += place(t) + ", .amplitudes = {" + amplitudes + "}}";
    }
    return ",\n    ." + name + " = {\n        " + text + "}";
  }

  /// A text that is safe in a string literal; names of nodes contain no other characters.
  static std::string literal(std::string_view text) { return "\"" + robots::cpp::comment(text) + "\""; }

  std::string nodes_text() const {
    std::string text;
    for (const mechanics::flexible_node& n : data_.nodes) {
      text += (text.empty() ? "{" : ",\n              {") + (".called = " + literal(n.called.view())) +
              ",\n" + std::string(15, ' ') + ".position = " + list(n.position.coefficients, 28) + ",\n" +
              std::string(15, ' ') + ".orientation = " + list(n.orientation, 31) + ",\n" +
              std::string(15, ' ') + ".rotation = " + list(n.rotation, 28);
      if (!n.second_rotation.empty())
        text += ",\n" + std::string(15, ' ') + ".second_rotation = " + list(n.second_rotation, 35);
      text += "}";
    }
    return text;
  }

  const mechanics::flexible_data& data_;
};

} // namespace kanexpr::flexible
