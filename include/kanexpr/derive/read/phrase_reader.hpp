#pragma once

#include <kanexpr/derive/read/senseless.hpp>
#include <kanexpr/derive/read/symbol_reader.hpp>
#include <kanexpr/derive/read/value.hpp>
#include <kanexpr/describe/motion.hpp>
#include <kanexpr/mechanics/checks/check_numbers.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>

namespace kanexpr::deriving {

/// Evaluates the postfix phrases of a model. `Entities` is the class derived from this one, which knows the
/// frames and points that phrases mention.
template <class Entities>
class phrase_reader : public symbol_reader {
public:
  using symbol_reader::symbol_reader;

  /// What a phrase of `whom` stands for. Motions are not known yet while a model is read: they fail here.
  constexpr value evaluate(const phrase& p, std::string_view whom) {
    if (p.kind == shape::vanishing || p.kind == shape::kinematics)
      fail({part_, whom, is_a(p.kind), "it must be an expression"});
    const sequence<value> found = evaluate_each(p, whom);
    if (mistake_ || found.empty()) return value::of(m_.zero());
    return found.back();
  }

  /// From here on phrases may speak of positions, velocities and derivatives.
  constexpr void know(mechanics::equations& derived) { derived_ = &derived; }

protected:
  /// What a phrase of several expressions, one after another, stands for.
  constexpr sequence<value> evaluate_each(const phrase& p, std::string_view whom) {
    sequence<value> stack;
    const phrase* const before = reading_; // which mentions what this one belongs to
    reading_ = &p;
    for (int i = 0; i < p.size && !mistake_; ++i) {
      const int known = m_.g->size();
      step(p.tokens[i], stack, whom);
      if (p.tokens[i].what <= describe::token_kind::normalized && m_.g->size() != known)
        look_for_no_number(known, p.tokens[i], whom);
    }
    reading_ = before;
    return stack;
  }

  /// A phrase that is the part `what` of an entity: "the offset of point ".
  constexpr value evaluate_part(std::string_view what, const phrase& p, std::string_view whom) {
    const std::string_view before = part_;
    part_ = what;
    const value v = evaluate(p, whom);
    part_ = before;
    return v;
  }

  constexpr expression scalar_of(const phrase& p, text_pieces what, std::string_view whom) {
    const value v = evaluate_part(*what.begin(), p, whom);
    if (mistake_) return m_.zero();
    if (p.kind == shape::scalar) return v.scalar;
    fail({what.begin()[0], what.begin()[1], is_a(p.kind), "it must be a scalar"});
    return m_.zero();
  }
  constexpr mechanics::vector vector_of(const phrase& p, text_pieces what, std::string_view whom) {
    const value v = evaluate_part(*what.begin(), p, whom);
    if (mistake_) return {};
    if (p.kind == shape::vector) return v.vector;
    fail({what.begin()[0], what.begin()[1], is_a(p.kind), "it must be a vector"});
    return {};
  }

  /// Whether a step means nothing for its operands.
  constexpr bool is_senseless(const describe::token& t, const value& a, std::string_view whom) {
    if (makes_sense(t, a.kind)) return false;
    if (!mistake_) mistake_ = senseless(t, a.kind, part_, whom);
    return true;
  }
  constexpr bool is_senseless(const describe::token& t, const value& a, const value& b,
                              std::string_view whom) {
    if (makes_sense(t, a.kind, b.kind)) return false;
    if (!mistake_) mistake_ = senseless(t, a.kind, b.kind, part_, whom);
    return true;
  }

  /// Words that C++ has and models do not.
  constexpr void check_written(const phrase& p, std::string_view whom) {
    for (int i = 0; i < p.size && !mistake_; ++i) {
      if (p.tokens[i].what != describe::token_kind::misused) continue;
      const bool named = !part_.empty() || whom.substr(0, 4) == "the ";
      const std::string_view held = named ? "" : name_in(p);
      fail({part_, whom, held.empty() ? "" : " with ", held,
            describe::what_is_wrong(static_cast<describe::misuse>(p.tokens[i].index))});
    }
  }

  /// What a step adds to the graph must be numbers where it holds no symbols.
  constexpr void look_for_no_number(int known, const describe::token& t, std::string_view whom) {
    using describe::token_kind;
    for (int id = known; id < m_.g->size() && !mistake_; ++id) {
      if (!mechanics::has_no_value(*m_.g, id)) continue;
      if (t.what == token_kind::normalized)
        fail({part_, whom, " holds normalized of a vector of no length"});
      else if (t.what != token_kind::scalar_function)
        fail({part_, whom, " holds a number that is not finite"});
      else if (t.operation == symbolic::operation::power)
        fail({part_, whom, " holds pow of numbers for which it has no value"});
      else
        fail({part_, whom, " holds ", symbolic::function_name(t.operation),
              " of a number for which it has no value"});
    }
  }

  constexpr void step(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    using describe::token_kind;
    const auto pop = [&] {
      value v = static_cast<value&&>(stack.back());
      stack.pop();
      return v;
    };
    switch (t.what) {
    case token_kind::number: stack.push(value::of(symbolic::constant(*m_.g, t.number))); break;
    case token_kind::symbol: stack.push(value::of(symbol(*t.symbol, whom))); break;
    case token_kind::basis: {
      mechanics::vector v;
      const int f = t.frame != nullptr ? entities().frame(t.frame, whom) : describing_;
      if (f == none)
        return fail({part_, whom, " holds own::", axis_names.substr(static_cast<std::size_t>(t.index), 1),
                     ", which stands for a frame while its angular velocity is declared"});
      v.add(f, mechanics::unit(*m_.g, t.index));
      stack.push(value::of(static_cast<mechanics::vector&&>(v)));
      break;
    }
    case token_kind::scalar_function: {
      const value b = pop();
      if (!symbolic::is_binary(t.operation)) {
        if (is_senseless(t, b, whom)) return;
        stack.push(value::of(symbolic::apply(t.operation, b.scalar)));
        break;
      }
      const value a = pop();
      if (is_senseless(t, a, b, whom)) return;
      stack.push(value::of({*m_.g, symbolic::build(*m_.g, t.operation, a.scalar.node(), b.scalar.node())}));
      break;
    }
    case token_kind::negate: stack.push(negative(m_, pop())); break;
    case token_kind::add: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      stack.push(sum(a, b));
      break;
    }
    case token_kind::subtract: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      stack.push(sum(a, negative(m_, b)));
      break;
    }
    case token_kind::multiply: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      stack.push(scaled(a.scalar, b));
      break;
    }
    case token_kind::divide: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      if (b.scalar.is_zero()) return fail({part_, whom, " is divided by zero"});
      if (a.kind == shape::scalar)
        stack.push(value::of(a.scalar / b.scalar));
      else
        stack.push(scaled(1 / b.scalar, a));
      break;
    }
    case token_kind::dot: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      if (a.kind == shape::dyadic)
        stack.push(value::of(dot(m_, a.dyadic, b.vector)));
      else
        stack.push(value::of(dot(m_, a.vector, b.vector)));
      break;
    }
    case token_kind::cross: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      stack.push(value::of(cross(m_, a.vector, b.vector)));
      break;
    }
    case token_kind::outer: {
      const value b = pop(), a = pop();
      if (is_senseless(t, a, b, whom)) return;
      stack.push(value::of(outer(m_, a.vector, b.vector)));
      break;
    }
    case token_kind::magnitude: {
      const value a = pop();
      if (is_senseless(t, a, whom)) return;
      stack.push(value::of(sqrt(dot(m_, a.vector, a.vector))));
      break;
    }
    case token_kind::normalized: {
      const value a = pop();
      if (is_senseless(t, a, whom)) return;
      stack.push(value::of(normalized(m_, a.vector)));
      break;
    }
    case token_kind::partial: {
      const expression by = symbol(*t.symbol, whom);
      value& of = stack.back();
      if (of.kind == shape::scalar) of.scalar = symbolic::differentiate(of.scalar, by);
      for (mechanics::vector::part& p : of.vector.parts)
        for (int i = 0; i < 3; ++i) p.value[i] = symbolic::differentiate(p.value[i], by);
      break;
    }
    case token_kind::in_axes: {
      const int axes = entities().frame(t.frame, whom);
      mechanics::vector v;
      v.add(axes, mechanics::express(m_, stack.back().vector, axes));
      stack.back().vector = v;
      break;
    }
    case token_kind::misused: return check_written(*reading_, whom);
    case token_kind::position:
    case token_kind::velocity:
    case token_kind::acceleration:
    case token_kind::angular_velocity:
    case token_kind::angular_acceleration:
    case token_kind::derivative: return motion(t, stack, whom);
    }
  }

  /// What a point or frame does, which only a model that has been read knows.
  constexpr void motion(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    using describe::token_kind;
    if (t.what == token_kind::position) {
      const int at = entities().point(t.point, whom);
      if (!mistake_) stack.push(value::of(mechanics::position_from_origin(m_, at)));
      return;
    }
    if (derived_ == nullptr) return declared_motion(t, stack, whom);
    mechanics::motion& k = derived_->moving();
    if (t.what == token_kind::velocity)
      stack.push(value::of(mechanics::velocity_of_point(k, entities().point(t.point, whom))));
    else if (t.what == token_kind::acceleration)
      stack.push(value::of(mechanics::acceleration_of_point(k, entities().point(t.point, whom))));
    else if (t.what == token_kind::angular_velocity)
      stack.push(value::of(mechanics::angular_velocity_of_frame(k, entities().frame(t.frame, whom))));
    else if (t.what == token_kind::angular_acceleration)
      stack.push(value::of(mechanics::angular_acceleration_of_frame(k, entities().frame(t.frame, whom))));
    else if (t.frame == nullptr)
      stack.back().scalar = k.rate(k.known(stack.back().scalar));
    else
      stack.back().vector = mechanics::derivative_in(k, stack.back().vector, entities().frame(t.frame, whom));
  }

  /// Whether a word is known while a model is read: of velocities, only those are that it declares in the
  /// inertial frame.
  constexpr bool is_declared(const describe::token& t) const {
    using describe::token_kind;
    if (t.what == token_kind::velocity) return t.point->reference == from_.inertial;
    if (t.what == token_kind::angular_velocity) return t.frame->reference == from_.inertial;
    return t.what != token_kind::acceleration && t.what != token_kind::angular_acceleration &&
           t.what != token_kind::derivative;
  }

  constexpr void declared_motion(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    if (!is_declared(t))
      return fail(
          {part_, whom, " holds a velocity or derivative, which is not known yet while a model is read"});
    if (t.point != nullptr) {
      const int at = entities().point(t.point, whom);
      if (!mistake_) stack.push(value::of(m_.points[at].velocity));
    } else {
      const int of = entities().frame(t.frame, whom);
      if (!mistake_) stack.push(value::of(m_.frames[of].angular_velocity));
    }
  }

  mechanics::equations* derived_ = nullptr;
  const phrase* reading_ = nullptr;
  int describing_ = none; ///< the frame whose own axes `own` means

private:
  static constexpr std::string_view axis_names = "xyz";

  constexpr Entities& entities() { return static_cast<Entities&>(*this); }
};

} // namespace kanexpr::deriving
