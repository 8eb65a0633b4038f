#pragma once

#include "playground/model/names.hpp"
#include "playground/text/line.hpp"

#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace playground {

/// A model while it is being built from its lines: the builder, the names, and the values of the symbols.
class construction {
public:
  using vector = kanexpr::mechanics::vector;

  explicit construction(const std::string& inertial_frame) : b(inertial_frame) {
    declare(inertial_frame, b.inertial_frame());
  }

  kanexpr::runtime::builder b;
  std::map<std::string, double> start{}; ///< the values of symbols, in SI units

  void declare(const std::string& name, const entity& what) { fail(names_.add(name, what)); }
  const names& known() const { return names_; }

  template <class Kind>
  Kind find(const std::string& name, const std::string& kind) {
    const Kind* const found = names_.find<Kind>(name);
    if (found == nullptr)
      fail(names_.contains(name) ? name + " is not a " + kind : "unknown " + kind + ' ' + name);
    return found == nullptr ? Kind{} : *found;
  }
  frame_id frame(const std::string& name) { return find<frame_id>(name, "frame"); }
  point_id point(const std::string& name) { return find<point_id>(name, "point"); }

  /// The motion of all frames and points, for velocities in loads and constraints.
  kanexpr::mechanics::motion& moving() {
    if (!motion_) motion_.emplace(b.mechanism());
    return motion_->moving();
  }
  /// From now on, expressions may contain velocities.
  void allow_velocities() { has_velocities_ = true; }
  bool has_velocities() const { return has_velocities_; }

  void fail(const std::string& sentence) {
    if (wrong_.empty()) wrong_ = sentence;
  }
  /// The first mistake, in a line or in a call to the builder.
  std::string wrong() const { return wrong_.empty() ? std::string(b.mistake().view()) : wrong_; }

private:
  names names_{};
  std::optional<kanexpr::mechanics::known_motion> motion_{};
  bool has_velocities_ = false;
  std::string wrong_{};
};

} // namespace playground
