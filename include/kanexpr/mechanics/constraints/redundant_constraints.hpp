#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/mechanics/model/wording.hpp>

/// Configuration constraints that the model declares redundant.
namespace kanexpr::mechanics {

constexpr sentence check_redundant(const given_constraints& all) {
  for (int i = 0; i < all.redundant.size(); ++i) {
    const int number = all.redundant[i];
    if (number < 1 || number > all.on_configuration.size())
      return sentence({"redundant<", base::counted(number).view(), "> is out of range: the model has ",
                       several(all.on_configuration.size(), "configuration constraint").view()});
    for (int j = 0; j < i; ++j)
      if (all.redundant[j] == number)
        return sentence({"configuration constraint ", base::counted(number).view(),
                         " is listed twice in redundant<...>"});
  }
  return {};
}

/// The constraints used in solving.
constexpr given_constraints without_redundant(const given_constraints& all) {
  if (all.redundant.empty()) return all;
  given_constraints solved = all;
  solved.on_configuration.clear(), solved.rates_by_auxiliary.clear();
  for (int i = 0; i < all.on_configuration.size(); ++i) {
    if (all.redundant.contains(i + 1)) continue;
    solved.on_configuration.push(all.on_configuration[i]);
    if (!all.rates_by_auxiliary.empty()) solved.rates_by_auxiliary.push(all.rates_by_auxiliary[i]);
  }
  return solved;
}

/// Records the numbers of the constraints used in solving, and the redundant ones.
constexpr void record_redundant(const given_constraints& all, constraints& c) {
  for (int i = 0; i < all.on_configuration.size(); ++i)
    if (all.redundant.contains(i + 1))
      c.redundant.push(all.on_configuration[i]);
    else
      c.numbers.push(i + 1);
}

/// The redundant constraints, as constraints on the speeds.
constexpr constraints only_redundant(motion& k, const constraints& c) {
  given_constraints alone;
  alone.on_configuration = c.redundant;
  return form_constraints(k, alone);
}

} // namespace kanexpr::mechanics
