#pragma once

#include <kanexpr/derive/read/load_reader.hpp>
#include <kanexpr/describe/kinematics.hpp>
#include <kanexpr/mechanics/skeleton/orientation_kinematics.hpp>

namespace kanexpr::deriving {

using describe::body_record;

/// Reads the records of a model into a mechanism: once, by following them from bodies and loads to all that
/// they use. The first mistake stops the reading and is kept as a sentence.
class reader : public load_reader {
public:
  using load_reader::load_reader;

  constexpr void read() {
    if (from_.inertial == nullptr) return fail({"inertial<...> takes one frame"});
    read_lists();
    if (mistake_) return;
    frame(from_.inertial, "the system");
    visit_lagrangian();
    for (int i = 0; i < from_.bodies.size && !mistake_; ++i) read_body(from_.bodies[i]);
    for (int i = 0; i < from_.loads.size && !mistake_; ++i) read_load(from_.loads[i]);
    for (int i = 0; i < from_.kinematics.size && !mistake_; ++i) read_kinematics(from_.kinematics[i]);
    visit_constraints();
    check_values_are_used();
  }

private:
  constexpr void read_lists() {
    for (int i = 0; i < from_.coordinates.size; ++i)
      if (const symbol_record* s = listed_symbol(from_.coordinates[i], symbolic::symbol_kind::coordinate,
                                                 symbol_list::coordinates))
        m_.coordinate(s->called);
    read_rates();
    for (int i = 0; i < from_.speeds.size; ++i)
      if (const symbol_record* s =
              listed_symbol(from_.speeds[i], symbolic::symbol_kind::speed, symbol_list::speeds))
        m_.speed(s->called);
    for (int i = 0; i < from_.auxiliary.size; ++i)
      if (const symbol_record* s =
              listed_symbol(from_.auxiliary[i], symbolic::symbol_kind::speed, symbol_list::auxiliary_speeds))
        m_.auxiliary_speed(s->called);
    for (int i = 0; i < from_.values.size; ++i) read_value(from_.values[i]);
    for (int i = 0; i < from_.parameters.size; ++i)
      if (const symbol_record* s =
              listed_symbol(from_.parameters[i], symbolic::symbol_kind::parameter, symbol_list::parameters))
        m_.parameter(s->called);
    for (int i = 0; i < from_.inputs.size; ++i)
      if (const symbol_record* s =
              listed_symbol(from_.inputs[i], symbolic::symbol_kind::input, symbol_list::inputs))
        place_input(*s);
    for (int i = 0; i < from_.inputs.size && !mistake_; ++i)
      check_derivative(*from_.inputs[i].tokens[0].symbol);
    for (int i = 0; i < from_.dependent.size && !mistake_; ++i) read_dependent(from_.dependent[i]);
  }

  constexpr void read_value(const phrase& p) {
    check_written(p, "values<...>");
    if (mistake_) return;
    const symbol_record* s = p.kind == shape::equation ? p.tokens[0].symbol : nullptr;
    phrase right{shape::scalar, p.tokens + 1, p.size - 2};
    if (s == nullptr && p.kind == shape::equation) { // 2.5 == m
      s = p.tokens[p.size - 2].symbol;
      right.tokens = p.tokens;
    }
    if (s == nullptr || !is_whole(right)) {
      const std::string_view held = name_in(p);
      return fail(
          {"values<...> takes equations such as m == 2.5 for parameters, and holds another expression",
           held.empty() ? "" : " with ", held});
    }
    if (s->kind != symbolic::symbol_kind::parameter)
      return fail({kind_of(*s), s->called.view(), " is given a value; only parameters have one"});
    if (is_bound(s->called)) return fail({"parameter ", s->called.view(), " is given two values"});
    for (int i = 0; i < right.size; ++i)
      if (right.tokens[i].symbol != nullptr)
        return fail({"the value of parameter ", s->called.view(), " is not a number: it holds ",
                     right.tokens[i].symbol->called.view()});
    const value number = evaluate_part("the value of parameter ", right, s->called.view());
    if (!mistake_ && (number.kind != shape::scalar || !number.scalar.is_constant()))
      fail({"the value of parameter ", s->called.view(), " is not a number"});
    bind(*s, number.scalar);
  }

  constexpr void read_kinematics(const phrase& p) {
    constexpr std::string_view whom = "a kinematic differential equation";
    if (p.kind == shape::kinematics) return read_kinematics_of(p.tokens[0].frame, p.tokens[1].frame);
    if (p.kind != shape::equation)
      return fail({"kinematics<...> holds something that is not an equation", p.size > 0 ? ", with " : "",
                   name_in(p), "; write dot(q) == u"});
    const value left_minus_right = evaluate(p, whom);
    if (!mistake_ && left_minus_right.kind != shape::scalar)
      fail({whom, " with ", name_in(p), " equates vectors; equate their dot products with basis vectors"});
    m_.kinematics.push(left_minus_right.scalar);
  }

  constexpr void read_kinematics_of(const frame_record* of, const frame_record* in) {
    if (in == nullptr)
      return fail({"kinematics_of takes two frames, and does not have them for ", of->called,
                   "; write kinematics_of<Frame, Reference>"});
    const int place = frame(of, "kinematics_of"), reference = frame(in, "kinematics_of");
    if (!mistake_) mistake_ = mechanics::check_orientation_kinematics(m_, place, reference);
    if (mistake_) return;
    for (const expression& e : mechanics::orientation_kinematics(m_, place, reference)) m_.kinematics.push(e);
  }

  constexpr void read_body(const body_record& r) {
    if (r.unparsed) return fail_by_unparsed(r.called, "bodies<...>");
    if (!words_belong(r.beside, r.called)) return;
    if (r.calls_itself.empty())
      return fail({"bodies<...> lists ", short_name(r.called).view(), ", which is ",
                   r.instead.empty() ? "not a body" : r.instead});
    if (r.called != r.calls_itself) return slip("body ", r.called, r.calls_itself);
    if (!r.fits) return wrong_count("body ", r.called, r.fits);
    if (r.has_whole_zeros && r.about == nullptr && !r.inertia_changes && !r.effective)
      return fail({"the inertia of ", r.called,
                   " is zero, as 1/2 is in C++; a body without an inertia is a particle<...>"});
    if (!r.instead_of_inertia.empty())
      return fail({"the inertia of ", r.called, " is ", r.instead_of_inertia, ", which is not an inertia"});
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
      b.inertia_changes = r.inertia_changes;
      b.effective = r.effective;
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
};

} // namespace kanexpr::deriving
