#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/base/zeros.hpp>
#include <kanexpr/lower/column_steps.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/numeric/symmetric_columns.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <cstdint>

namespace kanexpr::lower {

/// The arguments of equal branches of a mechanism, such as the legs of a quadruped.
struct equal_branches {
  int count = 0;             ///< of branches that are evaluated side by side: 4, 2, or 0 if none are equal
  sequence<int> arguments{}; ///< slots: for each role, the argument that plays it in each branch
};

namespace detail {

/// Finds the branches in the factors of the mass matrix, whose zeros show the tree: the multipliers of an
/// unknown that differ from zero belong to the unknowns between it and the root (Featherstone, Rigid Body
/// Dynamics Algorithms, 2008, section 6.5). Branches with trees of the same shape are candidates; the
/// coordinates and speeds of a branch are those on which its equations depend, but not those of the others.
class branch_search {
public:
  constexpr branch_search(const tape_view& t, int most_lanes) : tape_(t), most_lanes_(most_lanes) {}
  branch_search(const branch_search&) = delete;
  branch_search& operator=(const branch_search&) = delete;

  constexpr equal_branches run() {
    for (const linear_step& e : tape_.linear_steps)
      if (e.op == operation::symmetric_solve && (systems_.empty() || e.order == systems_[0].order))
        systems_.push(e);
    if (systems_.empty()) return {};
    order_ = systems_[0].order;
    find_tree();
    list_classes(none);
    int largest = 0;
    for (const sequence<int>& each : classes_)
      if (largest < each.size()) largest = each.size();
    found_.count = largest >= 4 && most_lanes_ >= 4 ? 4 : 2;
    if (largest < 2 || !find_dependencies()) return {};
    for (const sequence<int>& each : classes_)
      for (int first = 0; first + found_.count <= each.size(); first += found_.count) add(each, first);
    if (found_.arguments.empty()) return {};
    return static_cast<equal_branches&&>(found_);
  }

private:
  static constexpr int none = -1;

  constexpr int factor(int pivot, int later) const {
    return tape_.operands[systems_[0].operands + numeric::symmetric_factors{order_}.at(pivot, later)];
  }

  /// Finds the parent of each unknown, and the shape of the tree below it.
  constexpr void find_tree() {
    const int zero = slot_of_zero(tape_);
    parent_.resize(order_, none);
    shape_.resize(order_, 0);
    for (int i = 0; i < order_; ++i) {
      constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
      const std::uint64_t of_children = shape_[i];
      shape_[i] = (of_children ^ (of_children >> 29)) * odd + 1;
      for (int later = i + 1; later < order_ && parent_[i] == none; ++later)
        if (factor(i, later) != zero) parent_[i] = later;
      if (parent_[i] != none) shape_[parent_[i]] = shape_[parent_[i]] * odd + shape_[i];
    }
  }

  /// Lists the children of an unknown that have the same shape, and examines those below the others.
  constexpr void list_classes(int parent) {
    sequence<int> children;
    for (int i = order_ - 1; i >= 0; --i)
      if (parent_[i] == parent) children.push(i);
    for (int i = 0; i < children.size(); ++i) {
      sequence<int> equal;
      bool is_first = true;
      for (int j = 0; j < children.size(); ++j) {
        if (shape_[children[j]] != shape_[children[i]]) continue;
        is_first = is_first && j >= i;
        equal.push(children[j]);
      }
      if (equal.size() == 1)
        list_classes(children[i]);
      else if (is_first)
        classes_.push(equal);
    }
  }

  constexpr bool is_below(int unknown, int top) const {
    while (unknown != none && unknown < top) unknown = parent_[unknown];
    return unknown == top;
  }

  /// Finds the coordinates and the speeds on which each slot depends; false if there are too many.
  constexpr bool find_dependencies() {
    const int numbers = tape_.numbers.size(), first = tape_.first_step(), count = tape_.steps.size();
    on_coordinates_.grow(tape_.slot_count());
    on_speeds_.grow(tape_.slot_count());
    std::uint64_t *const coordinates = on_coordinates_.begin(), *const speeds = on_speeds_.begin();
    for (int i = 0; i < tape_.loads.size(); ++i) {
      const load l = tape_.loads[i];
      if (l.from != symbolic::symbol_kind::coordinate && l.from != symbolic::symbol_kind::speed) continue;
      if (l.position >= most) return false;
      const bool is_speed = l.from == symbolic::symbol_kind::speed;
      (is_speed ? speeds : coordinates)[numbers + i] = std::uint64_t{1} << l.position;
      (is_speed ? speed_ : coordinate_)[l.position] = numbers + i;
      if (is_speed) all_speeds_ |= std::uint64_t{1} << l.position;
    }
    const int *const a = tape_.steps.a, *const b = tape_.steps.b;
    for (int i = 0; i < count; ++i) {
      coordinates[first + i] = coordinates[a[i]] | coordinates[b[i]];
      speeds[first + i] = speeds[a[i]] | speeds[b[i]];
    }
    return true;
  }

  /// Adds the arguments of some branches of a class if each has the same number of them.
  constexpr void add(const sequence<int>& tops, int first) {
    std::uint64_t coordinates[4]{}, speeds[4]{};
    for (int k = 0; k < found_.count; ++k) {
      for (int i = 0; i <= tops[first + k]; ++i) {
        if (!is_below(i, tops[first + k])) continue;
        for (int later = i; later < order_; ++later) coordinates[k] |= on_coordinates_[factor(i, later)];
        speeds[k] |= speeds_of_equation(i);
      }
    }
    keep_own(coordinates);
    keep_own(speeds);
    for (int k = 1; k < found_.count; ++k)
      if (__builtin_popcountll(coordinates[k]) != __builtin_popcountll(coordinates[0]) ||
          __builtin_popcountll(speeds[k]) != __builtin_popcountll(speeds[0]))
        return;
    add_roles(coordinates, coordinate_);
    add_roles(speeds, speed_);
  }

  /// The speeds on which the right-hand sides of an equation depend, except those that depend on all because
  /// they depend on u̇.
  constexpr std::uint64_t speeds_of_equation(int row) const {
    std::uint64_t of_row = 0;
    for (const linear_step& e : systems_) {
      const int right = e.operands + numeric::symmetric_factors{e.order}.size();
      for (int j = 0; j < e.factors; ++j) {
        const std::uint64_t each = on_speeds_[tape_.operands[right + row * e.factors + j]];
        if (each != all_speeds_) of_row |= each;
      }
    }
    return of_row;
  }

  /// Removes what several branches have in common.
  constexpr void keep_own(std::uint64_t* sets) const {
    std::uint64_t any = 0, common = 0;
    for (int k = 0; k < found_.count; ++k) {
      common |= any & sets[k];
      any |= sets[k];
    }
    for (int k = 0; k < found_.count; ++k) sets[k] &= ~common;
  }

  constexpr void add_roles(std::uint64_t* sets, const int* arguments) {
    while (sets[0] != 0)
      for (int k = 0; k < found_.count; ++k) {
        found_.arguments.push(arguments[__builtin_ctzll(sets[k])]);
        sets[k] &= sets[k] - 1;
      }
  }

  static constexpr int most = 64;

  const tape_view& tape_;
  int most_lanes_;
  sequence<linear_step> systems_{}; ///< those with a mass matrix of the order of the first one
  int order_ = 0;
  sequence<int> parent_{}; ///< of each unknown
  sequence<std::uint64_t> shape_{};
  sequence<sequence<int>> classes_{};
  base::zeros<std::uint64_t> on_coordinates_{}, on_speeds_{}; ///< sets of positions, by slot
  std::uint64_t all_speeds_ = 0;
  int coordinate_[most]{}, speed_[most]{}; ///< slots, by position
  equal_branches found_{};
};

} // namespace detail

/// The equal branches of the mechanism whose mass matrix a tape solves with, for vectors of at most so many
/// lanes, at least 2.
constexpr equal_branches equal_branches_of(const tape_view& t, int most_lanes) {
  return detail::branch_search(t, most_lanes).run();
}

} // namespace kanexpr::lower
