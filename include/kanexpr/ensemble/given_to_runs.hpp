#pragma once

#include <kanexpr/compiled/named_values.hpp>
#include <kanexpr/ensemble/run_values.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::ensembles {

/// A vector of a system in each run: what it is in all of them, with what differs in its places.
template <class Given, class Vector>
class given_to_runs {
public:
  /// `range` is that of the vector's symbols in the survey.
  given_to_runs(const deriving::survey& known, const compiled::symbol_range& range, const runs& of,
                std::vector<named_value> same) {
    const run_values first(of, 0);
    for (std::size_t i = 0; i < of.varied().size(); ++i) {
      const varied_name& what = of.varied()[i];
      if (what.is_factor()) continue;
      for (int k = 0; k < range.size; ++k)
        if (known.names[range.first + k].view() == what.name()) {
          places_.emplace_back(i, k);
          same.push_back({what.name(), first.all()[i]});
        }
    }
    const Given given(same);
    values_ = given.values;
    mistake_ = given.mistake.view();
  }

  bool is_varied() const { return !places_.empty(); }
  const std::string& mistake() const { return mistake_; }

  Vector in(const run_values& run) const {
    Vector values = values_;
    for (const auto& [from, to] : places_) values(to) = run.all()[from];
    return values;
  }

private:
  std::vector<std::pair<std::size_t, int>> places_{};
  Vector values_{};
  std::string mistake_{};
};

} // namespace kanexpr::ensembles
