#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/print_vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/printing/latex_form.hpp>
#include <kanexpr/symbolic/printing/plain_text_form.hpp>
#include <kanexpr/symbolic/printing/write_within.hpp>

#include <cstddef>
#include <string>

namespace kanexpr::mechanics {

namespace vector_text {

constexpr char axis_letter(basis_style style, int axis) {
  return (style == basis_style::xyz ? "xyz" : style == basis_style::ijk ? "ijk" : "123")[axis];
}

class plain : public symbolic::printing::plain_text_form {
public:
  using symbolic::printing::plain_text_form::plain_text_form;

  std::string unit(const frame& f, int axis, basis_style style) const {
    return std::string(f.called.view()) + "." + axis_letter(style, axis);
  }
  std::string dyad(const std::string& left, const std::string& right) const {
    return "(" + left + "|" + right + ")";
  }
  std::string scaled(const std::string& measure, const std::string& unit) const {
    return measure + "*" + unit;
  }
};

class typeset : public symbolic::printing::latex_form {
public:
  using symbolic::printing::latex_form::latex_form;

  std::string unit(const frame& f, int axis, basis_style style) const {
    symbolic::printing::name_parts name(f.called.view());
    for (char& c : name.head)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (!name.subscript.empty()) name.subscript += ',';
    return "\\hat{\\mathbf{" + name.head + "}}_{" + name.subscript + axis_letter(style, axis) + "}";
  }
  std::string dyad(const std::string& left, const std::string& right) const {
    return left + " \\otimes " + right;
  }
  std::string scaled(const std::string& measure, const std::string& unit) const {
    return measure + "\\," + unit;
  }
};

template <class Form>
void add_part(symbolic::printing::sum_text& sum, const Form& form, expression measure,
              const std::string& unit) {
  if (measure.is_zero()) return;
  const auto [negative, text] = form.signed_factor(measure.node());
  if (text != "0") sum.add(negative, text == "1" ? unit : form.scaled(text, unit));
}

template <class Form>
std::string write(const mechanism& m, const vector& v, basis_style style, std::size_t longest) {
  base::sequence<int> measures;
  for (const vector::part& p : v.parts)
    for (int i = 0; i < 3; ++i) measures.push(p.value[i].node());
  return symbolic::printing::write_within<Form>(longest, *m.g, measures, [&](const Form& form) {
    symbolic::printing::sum_text sum;
    for (const vector::part& p : v.parts)
      for (int i = 0; i < 3; ++i) add_part(sum, form, p.value[i], form.unit(m.frames[p.frame], i, style));
    return sum.text();
  });
}

template <class Form>
std::string write(const mechanism& m, const dyadic& d, basis_style style, std::size_t longest) {
  base::sequence<int> measures;
  for (const dyadic::part& p : d.parts)
    for (int i = 0; i < 9; ++i) measures.push(p.value(i / 3, i % 3).node());
  return symbolic::printing::write_within<Form>(longest, *m.g, measures, [&](const Form& form) {
    symbolic::printing::sum_text sum;
    for (const dyadic::part& p : d.parts)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          add_part(sum, form, p.value(i, j),
                   form.dyad(form.unit(m.frames[p.left], i, style), form.unit(m.frames[p.right], j, style)));
    return sum.text();
  });
}

} // namespace vector_text

KANEXPR_ENGINE std::string print(const mechanism& m, const vector& v, basis_style style,
                                 std::size_t longest) {
  return vector_text::write<vector_text::plain>(m, v, style, longest);
}
KANEXPR_ENGINE std::string print(const mechanism& m, const dyadic& d, basis_style style,
                                 std::size_t longest) {
  return vector_text::write<vector_text::plain>(m, d, style, longest);
}

KANEXPR_ENGINE std::string latex(const mechanism& m, const vector& v, basis_style style,
                                 std::size_t longest) {
  return vector_text::write<vector_text::typeset>(m, v, style, longest);
}
KANEXPR_ENGINE std::string latex(const mechanism& m, const dyadic& d, basis_style style,
                                 std::size_t longest) {
  return vector_text::write<vector_text::typeset>(m, d, style, longest);
}

} // namespace kanexpr::mechanics
