#pragma once

#include <kanexpr/derive/value.hpp>
#include <kanexpr/derive/wording.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/describe/system.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/frames.hpp>
#include <kanexpr/mechanics/observe.hpp>
#include <kanexpr/mechanics/problem.hpp>

namespace kanexpr::derivation {

using describe::body_record;
using describe::frame_record;
using describe::load_record;
using describe::phrase;
using describe::point_record;
using describe::shape;
using describe::symbol_record;
using describe::system_record;
using mechanics::mechanism;
using mechanics::none;
using mechanics::problem;
using mechanics::sentence;

/// Reads the records of a model into a mechanism: once, by following them from bodies and loads to all that
/// they use. The first mistake stops the reading and is kept as a sentence.
class reader {
public:
  constexpr reader(const system_record& from, mechanism& into) : from_(from), m_(into) {}

  constexpr const problem& mistake() const { return mistake_; }

  constexpr void read() {
    read_lists();
    if (mistake_) return;
    frame(from_.inertial, "the system");
    for (int i = 0; i < from_.bodies.size && !mistake_; ++i) read_body(from_.bodies[i]);
    for (int i = 0; i < from_.loads.size && !mistake_; ++i) read_load(from_.loads[i]);
    for (int i = 0; i < from_.kinematics.size && !mistake_; ++i) read_kinematics(from_.kinematics[i]);
  }

  /// What a phrase of `whom` stands for. Motions are not known yet while a model is read: they fail here.
  constexpr value evaluate(const phrase& p, std::string_view whom) {
    sequence<value> stack;
    for (int i = 0; i < p.size && !mistake_; ++i) step(p.tokens[i], stack, whom);
    if (mistake_ || stack.empty()) return value::of(m_.zero());
    return stack.back();
  }

  /// Reads the entities that a phrase mentions, before the mechanism is taken as complete.
  constexpr void visit(const describe::token* tokens, int size) {
    for (int i = 0; i < size && !mistake_; ++i) {
      if (tokens[i].frame != nullptr) frame(tokens[i].frame, "an expression");
      if (tokens[i].point != nullptr) point(tokens[i].point, "an expression");
    }
  }

  /// From here on phrases may speak of positions, velocities and derivatives.
  constexpr void know(mechanics::equations& derived) { derived_ = &derived; }

  /// The number of a frame that `whom` mentions; it and all that it hangs on are read if they were not yet.
  constexpr int frame(const frame_record* r, std::string_view whom) {
    for (int i = 0; i < frames_.size(); ++i)
      if (frames_[i] == r) return places_of_frames_[i];
    if (derived_ != nullptr)
      fail({"frame ", r->called, " of ", whom, " is not part of the system that was derived"});
    check_frame(*r, whom);
    if (mistake_) return mechanism::inertial;
    const int describing_before = describing_;
    describing_ = none;
    open_frames_.push(r);
    const int parent = r->parent != nullptr ? frame(r->parent, r->called) : none;
    if (mistake_) return mechanism::inertial;
    const int place = add_frame(*r, parent);
    open_frames_.pop();
    frames_.push(r);
    places_of_frames_.push(place);
    if (r->reference != nullptr && !mistake_) {
      describing_ = place;
      const int reference = frame(r->reference, r->called);
      const mechanics::vector w =
          vector_of(r->angular_velocity, {"the angular velocity of frame ", r->called}, r->called);
      if (!mistake_) mechanics::declare_angular_velocity(m_, place, reference, w);
    }
    describing_ = describing_before;
    return place;
  }

  constexpr int point(const point_record* r, std::string_view whom) {
    const int present = points_.find(r);
    if (present >= 0) return present;
    if (derived_ != nullptr)
      fail({"point ", r->called, " of ", whom, " is not part of the system that was derived"});
    check_point(*r, whom);
    if (mistake_) return 0;
    mechanics::point p;
    p.called = symbolic::name(r->called);
    if (r->parent != nullptr) {
      open_points_.push(r);
      p.parent = point(r->parent, r->called);
      open_points_.pop();
      p.offset = vector_of(r->offset, {"the offset of point ", r->called}, r->called);
    } else if (frame(r->origin_of, r->called) != mechanism::inertial) {
      fail({"origin ", r->called,
            " does not stand in the inertial frame; a point that moves needs an offset"});
    }
    if (r->fixed_in != nullptr) p.fixed_in = frame(r->fixed_in, r->called);
    if (r->reference != nullptr) {
      p.reference = frame(r->reference, r->called);
      p.velocity = vector_of(r->velocity, {"the velocity of point ", r->called}, r->called);
    }
    if (mistake_) return 0;
    points_.push(r);
    return m_.points.push(p);
  }

  constexpr expression symbol(const symbol_record& r, std::string_view whom) {
    using symbolic::symbol_kind;
    switch (r.kind) {
    case symbol_kind::time: return m_.time;
    case symbol_kind::coordinate: return listed(m_.coordinates, m_.coordinates, r, "coordinate", whom);
    case symbol_kind::coordinate_rate:
      return listed(m_.coordinates, m_.coordinate_rates, r, "coordinate", whom);
    case symbol_kind::speed: return listed(m_.speeds, m_.speeds, r, "speed", whom);
    case symbol_kind::speed_rate: return listed(m_.speeds, m_.speed_rates, r, "speed", whom);
    case symbol_kind::parameter:
      for (int i = 0; i < bound_.size(); ++i)
        if (bound_[i] == r.called) return bound_values_[i];
      return mentioned(m_.parameters, r, from_.parameters.size != 0, "parameter", whom);
    case symbol_kind::input: return mentioned(m_.inputs, r, from_.inputs.size != 0, "input", whom);
    }
    return m_.zero();
  }

private:
  using words = std::initializer_list<std::string_view>;
  static constexpr std::string_view axis_names = "xyz";

  constexpr void fail(words pieces) {
    if (!mistake_) mistake_ = sentence(pieces);
  }

  /// `struct B : rotated<A, ...>` would be a second A.
  constexpr void slip(std::string_view kind, std::string_view called, std::string_view other) {
    fail({kind, called, " calls itself ", other, "; the first argument of what it is derived from must be ",
          called});
  }

  constexpr void read_lists() {
    for (int i = 0; i < from_.coordinates.size; ++i)
      if (const symbol_record* s =
              listed_symbol(from_.coordinates[i], symbolic::symbol_kind::coordinate, "coordinates"))
        m_.coordinate(s->called);
    for (int i = 0; i < from_.speeds.size; ++i)
      if (const symbol_record* s = listed_symbol(from_.speeds[i], symbolic::symbol_kind::speed, "speeds"))
        m_.speed(s->called);
    for (int i = 0; i < from_.values.size; ++i) read_value(from_.values[i]);
    for (int i = 0; i < from_.parameters.size; ++i)
      if (const symbol_record* s =
              listed_symbol(from_.parameters[i], symbolic::symbol_kind::parameter, "parameters"))
        m_.parameter(s->called);
    for (int i = 0; i < from_.inputs.size; ++i)
      if (const symbol_record* s = listed_symbol(from_.inputs[i], symbolic::symbol_kind::input, "inputs"))
        m_.input(s->called);
  }

  constexpr const symbol_record* listed_symbol(const phrase& p, symbolic::symbol_kind kind,
                                               std::string_view list) {
    if (p.size != 1 || p.tokens[0].what != describe::word::symbol) {
      fail({"the list of ", list, " holds something that is not a symbol", p.size > 1 ? ", with " : "",
            name_in(p)});
      return nullptr;
    }
    const symbol_record* s = p.tokens[0].symbol;
    if (s->kind != kind) {
      fail({kind_of(*s), s->called.view(), " stands in the list of ", list});
      return nullptr;
    }
    claim_name(s->called, list);
    return s;
  }

  /// A name means one thing in a system.
  constexpr void claim_name(const symbolic::name& called, std::string_view list) {
    for (int i = 0; i < names_.size(); ++i)
      if (names_[i] == called) {
        if (lists_[i] == list)
          fail({called.view(), " is listed twice among the ", list});
        else if (lists_[i] == "values")
          fail({"parameter ", called.view(), " has a value and stands in the list of parameters too"});
        else
          fail(
              {"the name ", called.view(), " is used twice: among the ", lists_[i], " and among the ", list});
      }
    names_.push(called);
    lists_.push(list);
  }

  constexpr void read_value(const phrase& p) {
    const symbol_record* s = p.kind == shape::equation ? p.tokens[0].symbol : nullptr;
    const phrase right{shape::scalar, p.tokens + 1, p.size - 2};
    if (s == nullptr || !is_whole(right))
      return fail(
          {"values<...> takes equations such as m == 2.5 for parameters, and holds another expression",
           p.size > 0 ? " with " : "", name_in(p)});
    if (s->kind != symbolic::symbol_kind::parameter)
      return fail({kind_of(*s), s->called.view(), " is given a value; only parameters have one"});
    for (const symbolic::name& present : bound_)
      if (present == s->called) return fail({"parameter ", s->called.view(), " is given two values"});
    for (int i = 0; i < right.size; ++i)
      if (right.tokens[i].symbol != nullptr)
        return fail({"the value of parameter ", s->called.view(), " is not a number: it holds ",
                     right.tokens[i].symbol->called.view()});
    const value number = evaluate(right, s->called.view());
    if (!mistake_ && (number.kind != shape::scalar || !number.scalar.is_constant()))
      fail({"the value of parameter ", s->called.view(), " is not a number"});
    bound_.push(s->called);
    bound_values_.push(number.scalar);
    claim_name(s->called, "values");
  }

  constexpr void read_kinematics(const phrase& p) {
    constexpr std::string_view whom = "a kinematic differential equation";
    if (p.kind != shape::equation)
      return fail({"kinematics<...> holds something that is not an equation", p.size > 0 ? ", with " : "",
                   name_in(p), "; write dot(q) == u"});
    const value left_minus_right = evaluate(p, whom);
    if (!mistake_ && left_minus_right.kind != shape::scalar)
      fail({whom, " with ", name_in(p), " equates vectors; equate their dot products with basis vectors"});
    m_.kinematics.push(left_minus_right.scalar);
  }

  constexpr expression listed(const sequence<expression>& own, const sequence<expression>& wanted,
                              const symbol_record& r, std::string_view kind, std::string_view whom) {
    for (int i = 0; i < own.size(); ++i)
      if (m_.g->symbol_at(own[i].node()).called == r.called) return wanted[i];
    fail({kind, " ", r.called.view(), ", which ", part_, whom, " holds, is not in the list of ", kind, "s"});
    return m_.zero();
  }

  constexpr expression mentioned(sequence<expression>& known, const symbol_record& r, bool complete,
                                 std::string_view kind, std::string_view whom) {
    for (const expression& e : known)
      if (m_.g->symbol_at(e.node()).called == r.called) return e;
    if (complete) {
      fail(
          {kind, " ", r.called.view(), ", which ", part_, whom, " holds, is not in the list of ", kind, "s"});
      return m_.zero();
    }
    claim_name(r.called, kind == "input" ? "inputs" : "parameters");
    return r.kind == symbolic::symbol_kind::input ? m_.input(r.called) : m_.parameter(r.called);
  }

  // ---- frames and points

  constexpr void check_frame(const frame_record& r, std::string_view whom) {
    if (r.calls_itself.empty())
      return fail(
          {r.called, ", which ", whom, " uses as a frame, is not a frame, or is described only later"});
    if (r.called != r.calls_itself) return slip("frame ", r.called, r.calls_itself);
    if (&r == from_.inertial && r.orientation != describe::orientation_word::inertial)
      fail({"the inertial frame is said to be ", r.called, ", which stands in ", r.parent->called});
    if (r.orientation == describe::orientation_word::inertial && &r != from_.inertial)
      fail({"frame ", r.called, ", which ", whom, " uses, is not connected to the inertial frame ",
            from_.inertial->called});
    if (open_frames_.contains(&r)) fail({"frame ", r.called, " stands in itself"});
    for (const sequence<const frame_record*>* list : {&frames_, &open_frames_})
      for (const frame_record* f : *list)
        if (f->called == r.called) fail({"two frames are called ", r.called});
  }

  constexpr void check_point(const point_record& r, std::string_view whom) {
    if (r.calls_itself.empty())
      return fail(
          {r.called, ", which ", whom, " uses as a point, is not a point, or is described only later"});
    if (r.called != r.calls_itself) return slip("point ", r.called, r.calls_itself);
    if (open_points_.contains(&r)) fail({"point ", r.called, " is offset from itself"});
    for (const sequence<const point_record*>* list : {&points_, &open_points_})
      for (const point_record* p : *list)
        if (p->called == r.called) fail({"two points are called ", r.called});
    if (r.fixed_in != nullptr && r.reference != nullptr)
      fail({"point ", r.called, " is said to be fixed in ", r.fixed_in->called,
            " and to have a velocity of its own"});
  }

  constexpr int add_frame(const frame_record& r, int parent) {
    using describe::orientation_word;
    const symbolic::name called(r.called);
    sequence<expression> given;
    for (const phrase& p : r.given)
      if (p.kind != shape::nothing) given.push(scalar_of(p, {what_is_given(r), r.called}, r.called));
    if (mistake_) return mechanism::inertial;
    switch (r.orientation) {
    case orientation_word::inertial: return mechanics::add_inertial_frame(m_, called);
    case orientation_word::rotated: {
      const mechanics::vector axis = vector_of(r.axis, {"the axis of frame ", r.called}, r.called);
      if (mistake_) return mechanism::inertial;
      const components a = mechanics::express(m_, axis, parent);
      if (a.is_zero()) fail({"frame ", r.called, " is turned about an axis of no length"});
      if (!fixed(a.x) || !fixed(a.y) || !fixed(a.z))
        fail({"frame ", r.called, " is turned about an axis that is not fixed in ", r.parent->called});
      return mistake_ ? mechanism::inertial : mechanics::add_rotated_frame(m_, called, parent, given[0], a);
    }
    case orientation_word::body_fixed:
    case orientation_word::space_fixed:
      if (!mechanics::is_sequence({r.sequence, 3})) {
        fail({"frame ", r.called,
              " is turned by a sequence that is none; take three axes, no two neighbours alike: zxz"});
        return mechanism::inertial;
      }
      return mechanics::add_frame_by_sequence(m_, called, parent, {r.sequence, 3}, given,
                                              r.orientation == orientation_word::space_fixed);
    case orientation_word::quaternion:
      return mechanics::add_frame_by_quaternion(m_, called, parent, given[0], given[1], given[2], given[3]);
    case orientation_word::direction_cosines: {
      matrix3 to_parent(*m_.g);
      for (int i = 0; i < 9; ++i) to_parent(i / 3, i % 3) = given[i];
      return mechanics::add_frame_by_matrix(m_, called, parent, to_parent);
    }
    }
    return mechanism::inertial;
  }

  /// Whether a scalar stays as it is while the system moves.
  constexpr bool fixed(expression e) const {
    const symbolic::node& n = (*m_.g)[e.node()];
    if (n.op == symbolic::operation::constant) return true;
    if (n.op == symbolic::operation::symbol)
      return m_.g->symbol_at(e.node()).kind == symbolic::symbol_kind::parameter;
    return fixed({*m_.g, n.a}) && (!symbolic::is_binary(n.op) || fixed({*m_.g, n.b}));
  }

  // ---- bodies and loads

  constexpr void read_body(const body_record& r) {
    if (r.calls_itself.empty()) return fail({"bodies<...> lists ", r.called, ", which is not a body"});
    if (r.called != r.calls_itself) return slip("body ", r.called, r.calls_itself);
    for (int i = 0; i < m_.bodies.size(); ++i) { // the bodies before this one
      if (&from_.bodies[i] == &r) return fail({"body ", r.called, " is listed twice"});
      if (from_.bodies[i].called == r.called) return fail({"two bodies are called ", r.called});
    }
    mechanics::body b;
    b.called = symbolic::name(r.called);
    b.mass = scalar_of(r.mass, {"the mass of ", r.called}, r.called);
    b.center = point(r.center, r.called);
    if (r.rigid) {
      b.frame = frame(r.frame, r.called);
      b.inertia = inertia_of(r);
      if (r.about != nullptr) b.about = point(r.about, r.called);
    }
    if (!mistake_) m_.bodies.push(b);
  }

  constexpr mechanics::dyadic inertia_of(const body_record& r) {
    mechanics::dyadic inertia;
    if (r.inertia_axes == nullptr) {
      const value v = evaluate_part("the inertia of ", r.inertia_dyadic, r.called);
      if (v.kind != shape::dyadic)
        fail({"the inertia of ", r.called, is_a(r.inertia_dyadic.kind),
              "it must be a dyadic: I*outer(A::x, A::x)"});
      return v.dyadic;
    }
    expression i[6];
    for (int k = 0; k < 6; ++k) i[k] = scalar_of(r.inertia[k], {"an inertia scalar of ", r.called}, r.called);
    matrix3 given;
    given.row[0] = {i[0], i[3], i[5]};
    given.row[1] = {i[3], i[1], i[4]};
    given.row[2] = {i[5], i[4], i[2]};
    const int axes = frame(r.inertia_axes, r.called);
    if (!mistake_) inertia.add(axes, axes, given);
    return inertia;
  }

  constexpr void read_load(const load_record& r) {
    switch (r.what) {
    case describe::load_word::force: {
      const int at = point(r.point, "a force");
      const mechanics::vector v = vector_of(r.value, {"the force at ", r.point->called}, r.point->called);
      if (!mistake_) m_.forces.push({at, v});
      break;
    }
    case describe::load_word::torque: {
      const int on = frame(r.frame, "a torque");
      const mechanics::vector v = vector_of(r.value, {"the torque on ", r.frame->called}, r.frame->called);
      if (!mistake_) m_.torques.push({on, v});
      break;
    }
    case describe::load_word::gravity: {
      if (m_.has_gravity) fail({"gravity is given twice"});
      const mechanics::vector v = vector_of(r.value, {"", "gravity"}, "gravity");
      if (mistake_) return;
      m_.has_gravity = true;
      m_.gravity = v;
      break;
    }
    case describe::load_word::none: fail({"loads<...> lists ", r.called, ", which is not a load"}); break;
    }
  }

  // ---- phrases

  /// A phrase that is the part `what` of an entity: "the offset of point ".
  constexpr value evaluate_part(std::string_view what, const phrase& p, std::string_view whom) {
    const std::string_view before = part_;
    part_ = what;
    const value v = evaluate(p, whom);
    part_ = before;
    return v;
  }

  constexpr expression scalar_of(const phrase& p, words what, std::string_view whom) {
    const value v = evaluate_part(*what.begin(), p, whom);
    if (mistake_) return m_.zero();
    if (p.kind == shape::scalar) return v.scalar;
    fail({what.begin()[0], what.begin()[1], is_a(p.kind), "it must be a scalar"});
    return m_.zero();
  }
  constexpr mechanics::vector vector_of(const phrase& p, words what, std::string_view whom) {
    const value v = evaluate_part(*what.begin(), p, whom);
    if (mistake_) return {};
    if (p.kind == shape::vector) return v.vector;
    fail({what.begin()[0], what.begin()[1], is_a(p.kind), "it must be a vector"});
    return {};
  }
  /// Words that mean nothing for these kinds of quantities.
  constexpr bool senseless(const describe::token& t, const value& a, const value& b, std::string_view whom) {
    using describe::word;
    const auto kind = [](const value& v) {
      return v.kind == shape::scalar ? "a scalar" : v.kind == shape::vector ? "a vector" : "a dyadic";
    };
    if ((t.what == word::add || t.what == word::subtract) && a.kind != b.kind)
      fail({part_, whom, t.what == word::add ? " adds " : " subtracts or equates ", kind(a), " and ",
            kind(b)});
    if (t.what == word::multiply && a.kind != shape::scalar)
      fail({part_, whom, " multiplies ", kind(a), " by ", kind(b), "; write dot, cross or outer"});
    if (t.what == word::divide && b.kind != shape::scalar)
      fail({part_, whom, " divides ", kind(a), " by ", kind(b)});
    if (t.what == word::divide && b.kind == shape::scalar && b.scalar.is_zero())
      fail({part_, whom, " is divided by zero"});
    return static_cast<bool>(mistake_);
  }

  constexpr void step(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    using describe::word;
    const auto pop = [&] {
      const value v = stack.back();
      stack.pop();
      return v;
    };
    switch (t.what) {
    case word::number: stack.push(value::of(symbolic::constant(*m_.g, t.number))); break;
    case word::symbol: stack.push(value::of(symbol(*t.symbol, whom))); break;
    case word::basis: {
      mechanics::vector v;
      const int f = t.frame != nullptr ? frame(t.frame, whom) : describing_;
      if (f == none)
        return fail({part_, whom, " holds own::", axis_names.substr(static_cast<std::size_t>(t.index), 1),
                     ", which stands for a frame while its angular velocity is declared"});
      v.add(f, mechanics::unit(*m_.g, t.index));
      stack.push(value::of(v));
      break;
    }
    case word::scalar_function: {
      const value b = pop();
      if (!symbolic::is_binary(t.operation)) {
        stack.push(value::of(symbolic::apply(t.operation, b.scalar)));
        break;
      }
      const value a = pop();
      stack.push(value::of({*m_.g, symbolic::build(*m_.g, t.operation, a.scalar.node(), b.scalar.node())}));
      break;
    }
    case word::negate: stack.push(negative(m_, pop())); break;
    case word::add: {
      const value b = pop(), a = pop();
      if (senseless(t, a, b, whom)) return;
      stack.push(sum(a, b));
      break;
    }
    case word::subtract: {
      const value b = pop(), a = pop();
      if (senseless(t, a, b, whom)) return;
      stack.push(sum(a, negative(m_, b)));
      break;
    }
    case word::multiply: {
      const value b = pop(), a = pop();
      if (senseless(t, a, b, whom)) return;
      stack.push(scaled(a.scalar, b));
      break;
    }
    case word::divide: {
      const value b = pop(), a = pop();
      if (senseless(t, a, b, whom)) return;
      if (a.kind == shape::scalar)
        stack.push(value::of(a.scalar / b.scalar));
      else
        stack.push(scaled(1 / b.scalar, a));
      break;
    }
    case word::dot: {
      const value b = pop(), a = pop();
      if (a.kind == shape::dyadic)
        stack.push(value::of(dot(m_, a.dyadic, b.vector)));
      else
        stack.push(value::of(dot(m_, a.vector, b.vector)));
      break;
    }
    case word::cross: {
      const value b = pop(), a = pop();
      stack.push(value::of(cross(m_, a.vector, b.vector)));
      break;
    }
    case word::outer: {
      const value b = pop(), a = pop();
      stack.push(value::of(outer(m_, a.vector, b.vector)));
      break;
    }
    case word::magnitude: {
      const value a = pop();
      stack.push(value::of(sqrt(dot(m_, a.vector, a.vector))));
      break;
    }
    case word::normalized: {
      const value a = pop();
      stack.push(value::of((1 / sqrt(dot(m_, a.vector, a.vector))) * a.vector));
      break;
    }
    default: motion(t, stack, whom); break;
    }
  }

  /// What a point or frame does, which only a model that has been read knows.
  constexpr void motion(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    using describe::word;
    if (derived_ == nullptr)
      return fail(
          {part_, whom,
           " holds a position, velocity or derivative, which is not known yet while a model is read"});
    mechanics::motion& k = derived_->moving();
    switch (t.what) {
    case word::position:
      stack.push(value::of(mechanics::position_from_origin(m_, point(t.point, whom))));
      break;
    case word::velocity: stack.push(value::of(mechanics::velocity_of_point(k, point(t.point, whom)))); break;
    case word::acceleration:
      stack.push(value::of(mechanics::acceleration_of_point(k, point(t.point, whom))));
      break;
    case word::angular_velocity:
      stack.push(value::of(mechanics::angular_velocity_of_frame(k, frame(t.frame, whom))));
      break;
    case word::angular_acceleration:
      stack.push(value::of(mechanics::angular_acceleration_of_frame(k, frame(t.frame, whom))));
      break;
    case word::derivative:
      if (t.frame == nullptr)
        stack.back().scalar = k.rate(k.known(stack.back().scalar));
      else
        stack.back().vector = mechanics::derivative_in(k, stack.back().vector, frame(t.frame, whom));
      break;
    case word::partial: {
      const expression by = symbol(*t.symbol, whom);
      value& of = stack.back();
      if (of.kind == shape::scalar) of.scalar = symbolic::differentiate(of.scalar, by);
      for (mechanics::vector::part& p : of.vector.parts)
        for (int i = 0; i < 3; ++i) p.value[i] = symbolic::differentiate(p.value[i], by);
      break;
    }
    case word::in_axes: {
      const int axes = frame(t.frame, whom);
      mechanics::vector v;
      v.add(axes, mechanics::express(m_, stack.back().vector, axes));
      stack.back().vector = v;
      break;
    }
    default: break;
    }
  }

  const system_record& from_;
  mechanism& m_;
  mechanics::equations* derived_ = nullptr;
  problem mistake_;
  sequence<const frame_record*> frames_;
  sequence<int> places_of_frames_; ///< a sequence of turns has frames of its own in between
  sequence<const point_record*> points_;
  sequence<symbolic::name> bound_;
  sequence<expression> bound_values_;
  sequence<symbolic::name> names_;
  sequence<std::string_view> lists_;
  sequence<const frame_record*> open_frames_; ///< that are being read
  sequence<const point_record*> open_points_;
  int describing_ = none; ///< the frame whose own axes `own` means
  std::string_view part_; ///< of an entity, that is being read: "the offset of point "
};

} // namespace kanexpr::derivation
