#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/runtime/building/builder_checks.hpp>
#include <kanexpr/runtime/building/number_or_expression.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <initializer_list>
#include <memory>
#include <string_view>

namespace kanexpr::mechanics {
struct wheel_on_ground;
}

namespace kanexpr::runtime {

/// The system of a builder, which all of its parts extend.
struct builder_core {
  std::shared_ptr<symbolic::graph> graph_ = std::make_shared<symbolic::graph>(); ///< shared with models
  mechanics::multibody_system system_{*graph_};
  builder_checks checks_{system_.mechanism};
  base::sequence<expression> used_elsewhere_{};

  builder_core& core() { return *this; }
};

/// A part of a builder: a class that adds one kind of entity to the system.
class builder_part {
protected:
  explicit builder_part(builder_core& core)
      : core_(core), system_(core.system_), m_(core.system_.mechanism), checks_(core.checks_) {}
  builder_part(const builder_part&) = delete;
  builder_part& operator=(const builder_part&) = delete;
  ~builder_part() = default;

  /// A constant; the integer 0 is a mistake.
  expression constant(given_number value);
  expression as_expression(const number_or_expression& given);
  /// A number or an expression; the integer 0 is a mistake.
  expression as_nonzero(const number_or_expression& given, std::string_view what);
  /// Whether at least one of the arguments is not the integer 0.
  bool not_all_zero(std::initializer_list<const number_or_expression*> given, std::string_view whose);
  bool is_new_body(std::string_view called);
  /// Checks that a wheel was returned by a function of this builder.
  bool owns_wheel(std::string_view whose, const mechanics::wheel_on_ground& wheel);
  /// Sets a unit vector that is fixed in a frame, and this frame.
  bool set_direction(mechanics::components& unit, int& frame, const vector& given, std::string_view whose);

  /// Whether a motion is that of this builder; otherwise reports that something is requested for it.
  bool is_own(const mechanics::known_motion& known, std::string_view requested);

  bool has_mistake() const { return static_cast<bool>(checks_.mistake()); }
  std::string_view name_of(frame_id f) const { return m_.frames[place(f)].called.view(); }
  std::string_view name_of(point_id p) const { return m_.points[place(p)].called.view(); }

  builder_core& core_;
  mechanics::multibody_system& system_;
  mechanics::mechanism& m_;
  builder_checks& checks_;
};

} // namespace kanexpr::runtime

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/runtime/building/builder_part.ipp>
#endif
