#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/exporting/casadi/sparsity.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

/// Gives sparse results of the same name in two functions the same sparsity by adding explicit zeros: two
/// derivations of a derivative may find different entries to be zero.
class common_shapes {
public:
  static void unify(exported_function& one, exported_function& other) {
    for (exported_result& a : one.results)
      for (exported_result& b : other.results) {
        if (a.name != b.name || !a.is_sparse) continue;
        const auto of_a = casadi_sparsity::of(a).places, of_b = casadi_sparsity::of(b).places;
        if (of_a == of_b) continue;
        auto all = of_a;
        all.insert(all.end(), of_b.begin(), of_b.end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        widen(one, a.name, all);
        widen(other, b.name, all);
      }
  }

private:
  using place = std::pair<int, int>; ///< column and row

  static void widen(exported_function& f, const std::string& name, const std::vector<place>& to) {
    lower::statements& code = f.code;
    const int zero = code.lines.push({.a = code.numbers.push(symbolic::exactly(0))});
    base::sequence<int> results;
    int next = 0; // entry of the previous results
    for (exported_result& each : f.results) {
      each.first = results.size();
      if (each.name != name) {
        for (int i = 0; i < each.entries(); ++i) results.push(code.results[next++]);
        continue;
      }
      const std::vector<place> from = casadi_sparsity::of(each).places;
      each.row_of.clear(), each.column_of.clear();
      for (const place& at : to) {
        const bool is_known = std::find(from.begin(), from.end(), at) != from.end();
        results.push(is_known ? code.results[next++] : zero);
        each.column_of.push_back(at.first), each.row_of.push_back(at.second);
      }
    }
    while (next < code.results.size()) results.push(code.results[next++]); // those of the checks
    code.results = results;
  }
};

} // namespace kanexpr::exporting
