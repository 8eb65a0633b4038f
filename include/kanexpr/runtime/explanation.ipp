#pragma once

#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/runtime/explain.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace kanexpr {

namespace runtime::detail {

constexpr std::size_t count_columns = 6;
using row_of_counts = std::array<std::string, count_columns + 1>;

inline row_of_counts row_of(const formulation_candidate& c) {
  const symbolic::cost& k = c.cost;
  return {c.called,
          std::to_string(k.multiplications + k.additions),
          std::to_string(k.fused),
          std::to_string(k.divisions),
          std::to_string(k.trigonometric),
          std::to_string(k.other),
          std::to_string(c.weighted)};
}

/// What a reader needs to know about the columns and the rows.
inline std::string notes_on(const explanation& forms) {
  std::string all = "weights:";
  for (const auto& [called, weight] : symbolic::weighted_operations) {
    all += std::string(all.back() == ':' ? " " : ", ") + called;
    all += ' ' + std::to_string(forms.weights.*weight);
  }
  all += "\nfused operations are sums with one product; mul + add includes both\n";
  const auto changes_speeds = [](const formulation_candidate& c) { return c.word.starts_with("dependent<"); };
  if (std::any_of(forms.candidates.begin(), forms.candidates.end(), changes_speeds))
    all +=
        "dependent<...> is never starred: it changes the states at which the constraints cannot be solved\n";
  return all;
}

} // namespace runtime::detail

KANEXPR_ENGINE const formulation_candidate& explanation::candidate(std::size_t place) const {
  static const formulation_candidate none{.cause = "the system has no forms"};
  return place < candidates.size() ? candidates[place] : none;
}

KANEXPR_ENGINE std::string explanation::text() const {
  using runtime::detail::count_columns;
  if (!mistake.empty()) return mistake + '\n';
  std::vector<runtime::detail::row_of_counts> rows{
      {"", "mul + add", "fused", "div", "sincos", "other", "weighted"}};
  for (const formulation_candidate& c : candidates) rows.push_back(runtime::detail::row_of(c));
  if (!candidates.empty() && solved_by != mechanics::solution::cheapest)
    rows[1][0] += solved_by == mechanics::solution::elimination ? " (elimination)" : " (articulated bodies)";
  std::array<std::size_t, count_columns + 1> widths;
  widths.fill(6);
  for (const auto& row : rows)
    for (std::size_t j = 0; j <= count_columns; ++j) widths[j] = (std::max)(widths[j], row[j].size());
  std::string all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_cheapest = i == cheapest + 1;
    all += (is_cheapest ? "* " : "  ") + rows[i][0] + std::string(widths[0] - rows[i][0].size(), ' ');
    if (i > 0 && !candidates[i - 1].applies()) {
      all += candidates[i - 1].is_left_out ? "  not formed: " : "  does not apply: ";
      all += candidates[i - 1].cause + '\n';
      continue;
    }
    for (std::size_t j = 1; j <= count_columns; ++j)
      all += "  " + std::string(widths[j] - rows[i][j].size(), ' ') + rows[i][j];
    all += '\n';
  }
  all += '\n' + runtime::detail::notes_on(*this);
  return all + (best().word.empty() ? "" : "\n" + best().word + '\n');
}

} // namespace kanexpr
