#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/call_reader.hpp>
#include <kanexpr/derivation/read/displacement.hpp>
#include <kanexpr/derivation/read/operations.hpp>
#include <kanexpr/derivation/read/symbol_reader.hpp>
#include <kanexpr/derivation/read/units_of_motion.hpp>
#include <kanexpr/describe/load_quantities.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/mechanics/checks/check_numbers.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/position.hpp>
#include <kanexpr/mechanics/motion/known_motion.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <concepts>
#include <string_view>

namespace kanexpr::derivation {

class entity_reader;

/// Looks up the indices of frames and points in the entity reader, which itself reads phrases.
struct entity_lookup {
  entity_reader& with;
  int (*frame)(entity_reader&, const frame_record*, std::string_view whom);
  int (*point)(entity_reader&, const point_record*, std::string_view whom);
};

class load_reader;

/// Looks up quantities of loads in the load reader, which itself reads phrases.
struct load_lookup {
  load_reader* with = nullptr;
  value (*quantity)(load_reader&, const describe::token&, std::string_view whom) = nullptr;
};

/// Evaluates the postfix phrases of a model.
class phrase_reader {
public:
  constexpr phrase_reader(reading& all, symbol_reader& symbols, const entity_lookup& entities)
      : reading_(all), m_(all.into.mechanism), symbols_(symbols), calls_(all), entities_(entities) {}

  constexpr void look_up_loads(const load_lookup& in) { loads_ = in; }

  /// Returns the value of a phrase of `whom`. Motions are not known while a model is read, so a phrase that
  /// contains one is a mistake.
  constexpr value evaluate(const phrase& p, std::string_view whom) {
    if (p.kind == shape::vanishing || p.kind == shape::kinematics || p.kind == shape::simple)
      reading_.fail({reading_.part, whom, is_a(p.kind), "it must be an expression"});
    sequence<value> found = evaluate_each(p, whom);
    if (reading_.mistake || found.empty()) return value::of(m_.zero());
    return static_cast<value&&>(found.back());
  }

  /// Returns the values of a phrase that consists of several expressions.
  constexpr sequence<value> evaluate_each(const phrase& p, std::string_view whom) {
    sequence<value> stack;
    const phrase* const before = phrase_; // the phrase that mentions the owner of this one
    phrase_ = &p;
    for (int i = 0; i < p.size && !reading_.mistake; ++i) {
      const int known = m_.g->size();
      step(p.tokens[i], stack, whom);
      if (p.tokens[i].what <= describe::token_kind::normalized && m_.g->size() != known)
        check_constants(known, p.tokens[i], whom);
    }
    phrase_ = before;
    return stack;
  }

  /// Returns the same values with points and axes displaced by auxiliary speeds (displacement.hpp). Requires
  /// that `set_known_motion` was called.
  constexpr sequence<value> evaluate_each_displaced(const phrase& p, std::string_view whom) {
    is_displaced_ = true;
    const sequence<value> found = evaluate_each(p, whom);
    is_displaced_ = false;
    return found;
  }

  /// Evaluates a phrase that is a part of an entity; `what` names the part, as in "the offset of point ".
  constexpr value evaluate_part(std::string_view what, const phrase& p, std::string_view whom) {
    const std::string_view before = reading_.part;
    reading_.part = what;
    value v = evaluate(p, whom);
    reading_.part = before;
    return v;
  }

  using text_pieces = std::initializer_list<std::string_view>;

  /// Evaluates a phrase that must be a scalar; `what` names it, as in {"the mass of ", "B"}.
  constexpr expression scalar_of(const phrase& p, text_pieces what, std::string_view whom) {
    if (is_one_scalar(p) && !reading_.mistake) return one_scalar(*what.begin(), p.tokens[0], whom);
    const value v = evaluate_part(*what.begin(), p, whom);
    if (reading_.mistake) return m_.zero();
    if (p.kind == shape::scalar) return v.scalar;
    reading_.fail({what.begin()[0], what.begin()[1], is_a(p.kind), "it must be a scalar"});
    return m_.zero();
  }
  constexpr mechanics::vector vector_of(const phrase& p, text_pieces what, std::string_view whom) {
    value v = evaluate_part(*what.begin(), p, whom);
    if (reading_.mistake) return {};
    if (p.kind == shape::vector) return static_cast<mechanics::vector&&>(v.vector);
    reading_.fail({what.begin()[0], what.begin()[1], is_a(p.kind), "it must be a vector"});
    return {};
  }

  /// Checks for constructs that C++ provides but models do not support.
  constexpr void check_misuse(const phrase& p, std::string_view whom) {
    for (const describe::token& t : p)
      if (t.what == describe::token_kind::misused) fail_by(static_cast<describe::misuse>(t.index), p, whom);
  }

  /// Whether a quantity is known while a model is read; a velocity is known only if it is declared in the
  /// inertial frame.
  constexpr bool is_declared(const describe::token& t) const {
    using describe::token_kind;
    if (t.what == token_kind::velocity)
      return t.point->reference == reading_.from.inertial && !t.point->from_parent;
    if (t.what == token_kind::angular_velocity) return t.frame->reference == reading_.from.inertial;
    if (t.what == token_kind::of_load) return is_of_position(t);
    return t.what != token_kind::acceleration && t.what != token_kind::angular_acceleration &&
           t.what != token_kind::derivative;
  }

private:
  constexpr void fail_by(describe::misuse what, const phrase& p, std::string_view whom) {
    const bool named = !reading_.part.empty() || whom.substr(0, 4) == "the ";
    const std::string_view held = named ? "" : name_in(p);
    reading_.fail(
        {reading_.part, whom, held.empty() ? "" : " with ", held, describe::misuse_message(what).view()});
  }

  /// The frame whose axes a hint suggests in place of those of a frame that is not yet available.
  constexpr std::string_view suggested_frame() const {
    return reading_.parent != nullptr ? reading_.parent->called : reading_.from.inertial->called;
  }

  /// Returns false and reports a mistake if the operands of a step have the wrong kind.
  constexpr bool check_operands(const describe::token& t, std::string_view whom,
                                const std::same_as<value> auto&... operand) {
    if (accepts(t, operand.kind...)) return true;
    if (!reading_.mistake) reading_.mistake = operand_mistake(t, operand.kind..., reading_.part, whom);
    return false;
  }

  /// Reports undefined constants that a step added to the graph.
  constexpr void check_constants(int known, const describe::token& t, std::string_view whom) {
    using describe::token_kind;
    for (int id = known; id < m_.g->size() && !reading_.mistake; ++id) {
      if (!mechanics::has_no_value(*m_.g, id)) continue;
      if (t.what == token_kind::normalized)
        reading_.fail({reading_.part, whom, " normalizes a vector of zero length"});
      else if (t.what == token_kind::composed)
        reading_.fail({reading_.part, whom, " contains ", call_reader::word_of(t).name,
                       " of numbers for which it is undefined"});
      else if (t.what != token_kind::scalar_function)
        reading_.fail({reading_.part, whom, " contains a number that is not finite"});
      else if (t.operation == symbolic::operation::power)
        reading_.fail({reading_.part, whom, " contains pow of numbers for which it is undefined"});
      else
        reading_.fail({reading_.part, whom, " contains ", symbolic::function_name(t.operation),
                       " of a number for which it is undefined"});
    }
  }

  /// Whether a phrase is a number or a symbol alone, as most masses and moments of inertia are. These are
  /// read without a stack.
  static constexpr bool is_one_scalar(const phrase& p) {
    using describe::token_kind;
    return p.size == 1 && p.kind == shape::scalar &&
           (p.tokens[0].what == token_kind::number || p.tokens[0].what == token_kind::symbol);
  }
  constexpr expression one_scalar(std::string_view part, const describe::token& t, std::string_view whom) {
    const std::string_view before = reading_.part;
    reading_.part = part;
    const int known = m_.g->size();
    const expression e = t.symbol != nullptr ? symbols_.symbol(*t.symbol, whom) : number(t);
    if (m_.g->size() != known) check_constants(known, t, whom);
    reading_.part = before;
    return reading_.mistake ? m_.zero() : e;
  }

  constexpr expression number(const describe::token& t) {
    const expression e = symbolic::constant(*m_.g, t.number);
    if (t.index != describe::whole_quantity) return e;
    reading_.hides_units = true;
    return reading_.for_units ? as_symbol(reading_, e) : e;
  }

  constexpr void step(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    using describe::token_kind;
    switch (t.what) {
    case token_kind::number: stack.push(value::of(number(t))); break;
    case token_kind::symbol: stack.push(value::of(symbols_.symbol(*t.symbol, whom))); break;
    case token_kind::basis: return basis_vector(t, stack, whom);
    case token_kind::scalar_function:
      return symbolic::is_binary(t.operation) ? combine(t, stack, whom) : transform(t, stack, whom);
    case token_kind::add:
    case token_kind::subtract:
    case token_kind::multiply:
    case token_kind::divide:
    case token_kind::dot:
    case token_kind::cross:
    case token_kind::outer: return combine(t, stack, whom);
    case token_kind::magnitude:
    case token_kind::normalized: return transform(t, stack, whom);
    case token_kind::negate: stack.back() = negative(m_, stack.back()); break;
    case token_kind::composed: return calls_.compose(t, stack, whom);
    case token_kind::external: return calls_.call(t, stack, whom);
    case token_kind::partial: {
      const expression by = symbols_.symbol(*t.symbol, whom);
      reading_.hides_units = true;
      return reading_.for_units ? divide_by(by, stack.back()) : differentiate(by, stack.back());
    }
    case token_kind::in_axes: return express(frame(t.frame, whom), stack.back().vector);
    case token_kind::length: return check_length(stack.back(), whom);
    case token_kind::wheel_axis: return check_wheel_axis(t, stack.back().vector, whom);
    case token_kind::of_load: return quantity_of_load(t, stack, whom);
    case token_kind::misused: return check_misuse(*phrase_, whom);
    case token_kind::position:
    case token_kind::velocity:
    case token_kind::acceleration:
    case token_kind::angular_velocity:
    case token_kind::angular_acceleration:
    case token_kind::derivative: return motion(t, stack, whom);
    }
  }

  constexpr void basis_vector(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    const int f = t.frame != nullptr ? frame(t.frame, whom) : reading_.describing;
    const std::string_view axis = axis_names.substr(static_cast<std::size_t>(t.index), 1);
    if (f == none)
      return reading_.fail({reading_.part, whom, " contains own::", axis,
                            ", which is valid only in the declared angular velocity of a frame; write ",
                            suggested_frame(), "::", axis});
    value v;
    v.kind = shape::vector;
    v.vector.add(f, mechanics::unit(*m_.g, t.index));
    if (is_displaced_) v.vector = displaced_axis(reading_.known->moving(), f, v.vector);
    stack.push(static_cast<value&&>(v));
  }

  constexpr void combine(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    if (combine_in_place(t, stack)) return;
    const value b = static_cast<value&&>(stack.back());
    stack.pop();
    const value a = static_cast<value&&>(stack.back());
    stack.pop();
    if (!check_operands(t, whom, a, b)) return;
    if (t.what == describe::token_kind::divide && b.scalar.is_zero())
      return reading_.fail({reading_.part, whom, " contains a division by zero"});
    stack.push(combined(m_, t, a, b));
  }

  constexpr void transform(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    if (check_operands(t, whom, stack.back())) stack.back() = transformed(m_, t, stack.back());
  }

  static constexpr void differentiate(expression by, value& of) {
    if (of.kind == shape::scalar) of.scalar = symbolic::differentiate(of.scalar, by);
    for (mechanics::vector::part& p : of.vector.parts)
      for (int i = 0; i < 3; ++i) p.value[i] = symbolic::differentiate(p.value[i], by);
  }

  constexpr void express(int axes, mechanics::vector& v) {
    mechanics::vector there;
    there.add(axes, mechanics::express(m_, v, axes));
    v = there;
  }

  constexpr void check_length(const value& length, std::string_view whom) {
    if (length.scalar.is_constant() && m_.g->number_at(length.scalar.node()).value() < 0)
      fail_by(describe::misuse::negative_length, *phrase_, whom);
  }

  /// Checks that the axis about which a rolling body turns is fixed in the body.
  constexpr void check_wheel_axis(const describe::token& t, const mechanics::vector& axis,
                                  std::string_view whom) {
    if (is_displaced_) return;
    const int wheel = frame(t.frame, whom);
    if (!reading_.mistake && !mechanics::is_fixed(mechanics::express(m_, axis, wheel)))
      reading_.fail({reading_.part, whom, " has a wheel axis that is not fixed in ", t.frame->called});
  }

  /// Evaluates the motion of a point or frame, which is known only after the model was read.
  constexpr void motion(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    using describe::token_kind;
    if (reading_.for_units) return unit_of_motion(t, stack, whom);
    reading_.hides_units = true;
    if (t.what == token_kind::position) {
      const int at = point(t.point, whom);
      const describe::token* const before = &t == phrase_->tokens ? nullptr : &t - 1;
      if (before != nullptr && before->what == token_kind::position && !reading_.mistake)
        reading_.mistake = mechanics::check_position(m_, point(before->point, whom), at);
      if (reading_.mistake) return;
      mechanics::vector place = mechanics::position_from_origin(m_, at);
      if (is_displaced_) place = displaced_position(reading_.known->moving(), at, place);
      stack.push(value::of(static_cast<mechanics::vector&&>(place)));
      return;
    }
    if (reading_.known == nullptr) return declared_motion(t, stack, whom);
    mechanics::motion& k = reading_.known->moving();
    if (t.what == token_kind::velocity)
      stack.push(value::of(mechanics::velocity_of_point(k, point(t.point, whom))));
    else if (t.what == token_kind::acceleration)
      stack.push(value::of(mechanics::acceleration_of_point(k, point(t.point, whom))));
    else if (t.what == token_kind::angular_velocity)
      stack.push(value::of(mechanics::angular_velocity_of_frame(k, frame(t.frame, whom))));
    else if (t.what == token_kind::angular_acceleration)
      stack.push(value::of(mechanics::angular_acceleration_of_frame(k, frame(t.frame, whom))));
    else if (t.frame == nullptr)
      stack.back().scalar = k.rate(k.known(stack.back().scalar));
    else
      stack.back().vector = mechanics::derivative_in(k, stack.back().vector, frame(t.frame, whom));
  }

  constexpr void unit_of_motion(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    if (t.frame != nullptr) frame(t.frame, whom);
    if (t.point != nullptr) point(t.point, whom);
    if (reading_.mistake) return;
    if (t.what == describe::token_kind::derivative) return divide_by_second(reading_, stack.back());
    stack.push(value::of(motion_of_unit(reading_, t)));
  }

  constexpr void declared_motion(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    if (!is_declared(t))
      return reading_.fail(
          {reading_.part, whom,
           " contains a velocity or derivative, which is not yet known while the model is read"});
    if (t.point != nullptr) {
      const int at = point(t.point, whom);
      if (!reading_.mistake) stack.push(value::of(m_.points[at].velocity));
    } else {
      const int of = frame(t.frame, whom);
      if (!reading_.mistake) stack.push(value::of(m_.frames[of].angular_velocity));
    }
  }

  static constexpr bool is_of_position(const describe::token& t) {
    return describe::is_of_position(static_cast<describe::load_quantity>(t.index));
  }

  constexpr void quantity_of_load(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    reading_.hides_units = true;
    if (is_displaced_)
      return reading_.fail({reading_.part, whom, " uses ",
                            t.load->wheel != nullptr ? "penetration_of" : "length_of",
                            ", which systems with reactions<...> do not support in constraints",
                            t.load->wheel != nullptr ? "" : "; write magnitude(position_of<P, Q>)"});
    if (!is_of_position(t) && reading_.known == nullptr && !reading_.for_units)
      return reading_.fail({reading_.part, whom,
                            " contains the force of a load, which is not yet known while the model is read"});
    const value found = loads_.quantity(*loads_.with, t, whom);
    if (!reading_.mistake) stack.push(found);
  }

  static constexpr std::string_view axis_names = "xyz"sv;

  constexpr int frame(const frame_record* r, std::string_view whom) {
    return entities_.frame(entities_.with, r, whom);
  }
  constexpr int point(const point_record* r, std::string_view whom) {
    return entities_.point(entities_.with, r, whom);
  }

  reading& reading_;
  mechanism& m_;
  symbol_reader& symbols_;
  call_reader calls_;
  entity_lookup entities_;
  load_lookup loads_{};
  const phrase* phrase_ = nullptr;
  bool is_displaced_ = false;
};

} // namespace kanexpr::derivation
