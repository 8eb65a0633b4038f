#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/linear/linear_system.hpp>
#include <kanexpr/symbolic/printing/named_parts.hpp>
#include <kanexpr/symbolic/printing/text_with_parts.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::symbolic::printing {

/// Numbers the parts to which the texts of nodes refer, in the order in which they are needed; each follows
/// those that it contains. Returns the parts in this order.
template <class Form>
std::vector<int> number_parts(const Form& form, const sequence<int>& outputs, named_parts& parts) {
  struct visit {
    int id;
    std::vector<int> contained;
    std::size_t next;
  };
  std::vector<int> order;
  std::vector<visit> open{{graph::zero, {}, 0}};
  for (int id : outputs)
    for (int each : form.parts_of(id)) open[0].contained.push_back(each);
  std::vector<bool> is_known;
  while (!open.empty()) {
    visit& last = open.back();
    if (last.next < last.contained.size()) {
      const int id = last.contained[last.next++];
      const auto place = static_cast<std::size_t>(id);
      if (is_known.size() <= place) is_known.resize(place + 1);
      if (is_known[place]) continue;
      is_known[place] = true;
      open.push_back({id, form.parts_of_definition(id), 0});
    } else {
      if (open.size() > 1) {
        order.push_back(last.id);
        parts.number(last.id, static_cast<int>(order.size()));
      }
      open.pop_back();
    }
  }
  return order;
}

inline std::size_t length_of(const std::string& text) { return text.size(); }
inline std::size_t length_of(const std::vector<std::string>& texts) {
  std::size_t all = 0;
  for (const std::string& each : texts) all += each.size();
  return all;
}

/// The text, or the texts, that `compose` makes with a form, and the parts to which it refers.
template <class Text>
struct composed_text {
  Text text{};
  std::vector<text_with_parts::part> parts{};
};

/// Writes expressions in full if this takes at most `longest` characters, otherwise with named parts.
template <class Form, class Compose>
auto compose_within(std::size_t longest, const graph& g, const sequence<int>& outputs,
                    const Compose& compose) {
  composed_text<decltype(compose(std::declval<const Form&>()))> found;
  {
    const Form form(g, longest);
    found.text = compose(form);
    if (!form.is_cut_short() && length_of(found.text) <= longest) return found;
  }
  named_parts parts(g, outputs);
  const Form form(g, Form::any_length, &parts);
  for (int id : number_parts(form, outputs, parts))
    found.parts.push_back({form.reference(id), form.definition(id)});
  found.text = compose(form);
  return found;
}

/// The same as one text, in which the definitions of the parts follow.
template <class Form, class Compose>
std::string write_within(std::size_t longest, const graph& g, const sequence<int>& outputs,
                         const Compose& compose) {
  const composed_text<std::string> found = compose_within<Form>(longest, g, outputs, compose);
  return found.parts.empty() ? found.text : Form::with_definitions(found.text, found.parts);
}

/// Each expression as a text of its own.
template <class Form>
text_with_parts write_each(std::size_t longest, const sequence<expression>& all) {
  if (all.empty()) return {};
  auto [texts, parts] = compose_within<Form>(longest, all[0].owner(), nodes_of(all), [&](const Form& form) {
    std::vector<std::string> each;
    for (const expression& e : all) each.push_back(form.write(e.node()));
    return each;
  });
  return {std::move(texts), std::move(parts)};
}

} // namespace kanexpr::symbolic::printing
