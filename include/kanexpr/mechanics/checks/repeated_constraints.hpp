#pragma once

#include <kanexpr/mechanics/constraints/constraints.hpp>
#include <kanexpr/mechanics/model/wording.hpp>

/// Configuration constraints that follow from the others only where all of them hold, such as the closure
/// equations of a loop with special geometry. In other configurations, they are independent and seem to
/// permit no motion.
namespace kanexpr::mechanics {

namespace detail {

/// Finds configurations in which all constraints hold, by the Levenberg–Marquardt method, which admits
/// redundant rows.
class closed_configurations {
public:
  constexpr closed_configurations(const mechanism& m, const symbolic::matrix& by_q,
                                  const sequence<expression>& all)
      : m_(m), by_q_(by_q), all_(all), sizes_(*m.g), evaluate_(*m.g, outputs(by_q, all)),
        generic_(*m.g, evaluate_.live(), &m, 1.0), symbols_(m.g->size(), 0.0) {
    for (const frame& f : m.frames) {
      bool is_free = !f.quaternion.empty();
      for (const expression& e : f.quaternion) is_free = is_free && m.coordinates.contains(e);
      if (is_free) quaternions_.push(&f);
    }
  }
  closed_configurations(const closed_configurations&) = delete;
  closed_configurations& operator=(const closed_configurations&) = delete;

  /// Finds a configuration from a new random start; returns false if the iteration does not converge.
  constexpr bool next() {
    generic_.draw();
    for (int id : evaluate_.live())
      if ((*m_.g)[id].op == symbolic::operation::symbol) symbols_[id] = generic_[id];
    row_sizes_.clear();
    if (!look()) return false;
    for (int i = 0; i < rows_.rows; ++i) row_sizes_.push(length_of_row(i));
    for (const double size : row_sizes_)
      if (!(size > 0)) return false;
    if (!look()) return false;
    double damping = 1e-2, last = left();
    for (int steps = 0; steps < 40 && last > closed; ++steps) {
      const sequence<double> before = symbols_;
      move(damping);
      if (const double now = look() ? left() : last; now < last) {
        last = now;
        damping = damping > 1e-9 ? damping / 10 : damping;
        continue;
      }
      symbols_ = before, damping *= 10;
      if (!look()) return false;
    }
    return last <= closed;
  }

  /// Return the number of leading rows, which contain the norms of quaternions, and a row. The rows of the
  /// constraints follow those of the norms, and each row is scaled to its usual size.
  constexpr int norms() const { return quaternions_.size(); }
  constexpr sequence<double> row(int i) const {
    sequence<double> entries;
    for (int j = 0; j < columns(); ++j) entries.push(rows_(i, j));
    return entries;
  }

private:
  static constexpr double closed = 1e-10;

  static constexpr sequence<int> outputs(const symbolic::matrix& by_q, const sequence<expression>& all) {
    sequence<int> nodes = symbolic::nodes_of(by_q.entries);
    for (const expression& e : all) nodes.push(e.node());
    return nodes;
  }
  constexpr int columns() const { return m_.coordinates.size(); }
  constexpr double length_of_row(int i) const {
    double square = 0;
    for (int j = 0; j < columns(); ++j) square += rows_(i, j) * rows_(i, j);
    return elementary::sqrt(square);
  }

  /// Evaluates the derivatives with respect to all coordinates, in units of the coordinates, and the
  /// residuals in the last column.
  constexpr bool look() {
    evaluate_.at([&](int id) { return symbols_[id]; });
    rows_ = numbers{norms() + all_.size(), columns() + 1, {}};
    for (const frame* f : quaternions_) {
      double square = 0;
      sequence<double> row(columns(), 0.0);
      for (const expression& e : f->quaternion) {
        const double entry = symbols_[e.node()];
        row[m_.coordinates.find(e)] = entry, square += entry * entry;
      }
      for (double each : row) rows_.entries.push(each);
      rows_.entries.push((square - 1) / 2);
    }
    for (int i = 0; i < all_.size(); ++i) {
      for (int j = 0; j < columns(); ++j)
        rows_.entries.push(evaluate_[by_q_(i, j).node()] * sizes_[m_.coordinates[j].node()]);
      rows_.entries.push(evaluate_[all_[i].node()]);
    }
    for (int i = 0; i < row_sizes_.size(); ++i)
      for (int j = 0; j <= columns(); ++j) rows_.entries[i * rows_.columns + j] /= row_sizes_[i];
    return rows_.finite();
  }
  constexpr double left() const {
    double square = 0;
    for (int i = 0; i < rows_.rows; ++i) square += rows_(i, columns()) * rows_(i, columns());
    return elementary::sqrt(square);
  }

  /// Takes the step δ of (Jᵀ J + damping) δ = −Jᵀ f, by a Cholesky factorization.
  constexpr void move(double damping) {
    const int n = columns();
    sequence<double> square(n * n, 0.0), step(n, 0.0);
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < rows_.rows; ++i) step[j] -= rows_(i, j) * rows_(i, n);
      for (int k = 0; k <= j; ++k) {
        double entry = j == k ? damping : 0;
        for (int i = 0; i < rows_.rows; ++i) entry += rows_(i, j) * rows_(i, k);
        for (int l = 0; l < k; ++l) entry -= square[j * n + l] * square[k * n + l];
        square[j * n + k] = j == k ? elementary::sqrt(entry) : entry / square[k * n + k];
      }
      for (int k = 0; k < j; ++k) step[j] -= square[j * n + k] * step[k];
      step[j] /= square[j * n + j];
    }
    for (int j = n; j-- > 0;) {
      for (int k = j + 1; k < n; ++k) step[j] -= square[k * n + j] * step[k];
      step[j] /= square[j * n + j];
      const int id = m_.coordinates[j].node();
      symbols_[id] += step[j] * sizes_[id];
    }
  }

  const mechanism& m_;
  const symbolic::matrix& by_q_;
  const sequence<expression>& all_;
  symbolic::typical_sizes sizes_;
  symbolic::evaluation evaluate_;
  generic_values generic_;
  sequence<double> symbols_, row_sizes_{};
  sequence<const frame*> quaternions_{};
  numbers rows_{};
};

} // namespace detail

/// The redundant constraints at configurations where all constraints hold.
struct repeated_constraints {
  bool is_known = false;  ///< true if such a configuration was found
  sequence<int> places{}; ///< the constraints that follow from the preceding ones there
};

constexpr repeated_constraints find_repeated(const mechanism& m, const symbolic::matrix& by_q,
                                             const sequence<expression>& all) {
  constexpr double nothing = 1e-6;
  repeated_constraints found;
  detail::closed_configurations closed(m, by_q, all);
  sequence<char> repeats(all.size(), 1);
  int looked = 0;
  for (int attempts = 0; attempts < 12 && looked < 2; ++attempts) {
    if (!closed.next()) continue;
    ++looked;
    row_space before(nothing);
    for (int i = 0; i < closed.norms() + all.size(); ++i) {
      sequence<double> row = closed.row(i);
      double square = 0;
      for (double e : row) square += e * e;
      const bool adds = square > nothing * nothing && before.add(row);
      if (adds && i >= closed.norms()) repeats[i - closed.norms()] = 0;
    }
  }
  found.is_known = looked > 0;
  for (int i = 0; i < all.size() && found.is_known; ++i)
    if (repeats[i] != 0) found.places.push(i);
  return found;
}

/// Numbers of constraints as "3, 4 and 5" and as "3, 4, 5".
struct numbered_constraints {
  sentence named{}, listed{};
};
constexpr numbered_constraints numbered(const sequence<int>& numbers) {
  numbered_constraints all;
  for (int i = 0; i < numbers.size(); ++i) {
    const name number = counted(numbers[i]);
    all.named = sentence({all.named.view(), before_entry(i, numbers.size()), number.view()});
    all.listed = sentence({all.listed.view(), i == 0 ? "" : ", ", number.view()});
  }
  return all;
}

/// Returns advice on constraints that seem to permit no motion: "; where all hold, configuration constraint 5
/// follows from the preceding ones; add redundant<5> to drop it". Empty if they really permit none.
constexpr sentence advice_on_redundant(const mechanism& m, const symbolic::matrix& by_q,
                                       const constraints& c) {
  if (c.on_configuration.size() < 2) return {};
  const repeated_constraints found = find_repeated(m, by_q, c.on_configuration);
  if (!found.is_known)
    return sentence({"; list configuration constraints that follow from others in redundant<...>"});
  const int count = found.places.size();
  if (count == 0 || c.on_configuration.size() - count >= m.coordinates.size()) return {};
  sequence<int> numbers;
  for (const int place : found.places) numbers.push(c.numbers[place]);
  const auto [named, listed] = numbered(numbers);
  return count == 1
             ? sentence({"; where all hold, configuration constraint ", named.view(),
                         " follows from the preceding ones; add redundant<", listed.view(), "> to drop it"})
             : sentence({"; where all hold, configuration constraints ", named.view(),
                         " follow from the preceding ones; add redundant<", listed.view(), "> to drop them"});
}

} // namespace kanexpr::mechanics
