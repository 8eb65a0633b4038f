#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/operation_weights.hpp>

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::runtime {

using base::sequence;

/// How a system is formed for a count: its formulation, and the speeds for which its constraints are solved,
/// if these are not those of the model.
struct formed_system {
  mechanics::formulation form{};
  sequence<int> dependent_speeds{};
  bool as_given = true; ///< as the model states, without these
};

/// Forms a system and passes its equations and the nodes of the counted results to a function; returns the
/// mistake, if there is one.
using forming = std::function<std::string(
    const formed_system&, const std::function<void(mechanics::equations&, const symbolic::cost&)>&)>;

/// The frames that may carry bodies, and the axes in which their equations may be written.
struct axes_of_system {
  struct body {
    int frame = 0, own = 0, below = 0; ///< its frame, its axes, and those of the frame in which it rotates
    sequence<int> axes{};              ///< all that are tried
    bool has_mass = false;
  };
  using usable_frames = std::function<bool(std::string_view)>;

  std::vector<body> bodies{};

  axes_of_system(const mechanics::skeleton& s, const usable_frames& may_use) : s_(s), may_use_(may_use) {
    for (int f = 1; f < s.model->frames.size(); ++f)
      if (s.rigid_with[f] == f && !is_flexible(f)) add(f);
  }

private:
  void add(int f) {
    const int below = s_.turns_in[f], farther = below == 0 ? 0 : s_.turns_in[below];
    body b{-1, usable(s_.body_axes[f]), usable(s_.body_axes[below]), {mechanics::mechanism::inertial}, false};
    for (int g = 1; g < s_.model->frames.size(); ++g) {
      if (!is_usable(g)) continue;
      const int moves = s_.rigid_with[g];
      if (b.frame < 0 && moves == f) b.frame = g;
      const bool is_near = moves == f || moves == below || moves == farther || s_.turns_in[moves] == f;
      if (moves != mechanics::mechanism::inertial && is_near) b.axes.push(g);
    }
    if (b.frame < 0) return;
    for (const mechanics::link& l : s_.links) b.has_mass = b.has_mass || l.frame == f;
    bodies.push_back(b);
  }

  /// Frames that joints and sequences of rotations add cannot be named in a model.
  bool is_usable(int f) const {
    const std::string_view called = s_.model->frames[f].called.view();
    return called.find('\'') == std::string_view::npos && (!may_use_ || may_use_(called));
  }
  /// A frame, or -1 if its axes cannot be used.
  int usable(int f) const { return f == mechanics::mechanism::inertial || is_usable(f) ? f : -1; }
  bool is_flexible(int f) const {
    for (const mechanics::flexible_part& p : s_.flexible_parts)
      if (p.frame == f) return true;
    return false;
  }

  const mechanics::skeleton& s_;
  const usable_frames& may_use_;
};

/// Varies the axes and the reference point of one body after another as long as the cost falls (a local
/// search; it finds no form that needs two changes at once).
class formulation_search {
public:
  formulation_search(const forming& form, const std::vector<axes_of_system::body>& bodies,
                     const symbolic::operation_weights& by)
      : form_(form), bodies_(bodies), by_(by) {}

  /// Searches from several forms, all with the solution and the speeds of the given one.
  mechanics::formulation cheapest_from(const mechanics::formulation& given) {
    mechanics::formulation best = given;
    long long least = cost_of(best);
    for (const start from : {start::given, start::own, start::below, start::ground}) {
      mechanics::formulation now = started(given, from);
      const long long cost = descend(now);
      if (cost < least) best = now, least = cost;
    }
    return without_idle_choices(best, least);
  }

private:
  enum class start { given, own, below, ground };

  mechanics::formulation started(mechanics::formulation form, start from) const {
    for (const axes_of_system::body& b : bodies_) {
      if (from == start::own) form.entry(b.frame).axes = b.own;
      if (from == start::below) form.entry(b.frame).axes = b.below;
      if (from == start::ground) form.entry(b.frame).axes = mechanics::mechanism::inertial;
    }
    return form;
  }

  long long descend(mechanics::formulation& form) {
    long long least = cost_of(form);
    for (bool falls = true; falls;) {
      falls = false;
      for (const axes_of_system::body& b : bodies_) {
        falls = vary(form, b.frame, b.axes, least) || falls;
        if (!b.has_mass) continue;
        mechanics::formulation other = form;
        other.entry(b.frame).about_the_center = !other.entry(b.frame).about_the_center;
        if (const long long cost = cost_of(other); cost < least) form = other, least = cost, falls = true;
      }
    }
    return least;
  }
  bool vary(mechanics::formulation& form, int frame, const sequence<int>& axes, long long& least) {
    bool falls = false;
    mechanics::formulation other = form;
    for (int i = -1; i < axes.size(); ++i) {
      other.entry(frame).axes = i < 0 ? -1 : axes[i];
      if (const long long cost = cost_of(other); cost < least) form = other, least = cost, falls = true;
    }
    return falls;
  }

  /// Leaves to the library what does not change the cost.
  mechanics::formulation without_idle_choices(mechanics::formulation form, long long least) {
    for (int i = form.frames.size() - 1; i >= 0; --i) {
      mechanics::formulation other = form;
      other.frames[i].axes = -1;
      if (cost_of(other) <= least) form = other;
    }
    mechanics::formulation stated = form;
    stated.frames.clear();
    for (const mechanics::formulation_of_frame& f : form.frames)
      if (f.axes >= 0 || f.about_the_center) stated.frames.push(f);
    return stated;
  }

  long long cost_of(const mechanics::formulation& form) {
    long long cost = (std::numeric_limits<long long>::max)(); // of a form that does not exist
    form_({form, {}, false}, [&](mechanics::equations&, const symbolic::cost& c) { cost = c.weighted(by_); });
    return cost;
  }

  const forming& form_;
  const std::vector<axes_of_system::body>& bodies_;
  const symbolic::operation_weights by_;
};

} // namespace kanexpr::runtime
