#pragma once

#include "playground/model/construction.hpp"
#include "playground/model/functions.hpp"
#include "playground/model/value.hpp"
#include "playground/text/tree.hpp"

#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/motion/observe.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace playground {

/// Evaluates expressions of lines as expressions and vectors of the builder.
class evaluator {
public:
  explicit evaluator(construction& in) : in_(in) {}

  expression scalar(const tree& e) {
    const value v = any(e);
    if (v.is_vector) in_.fail("expected a scalar, got a vector");
    return v.is_vector ? zero() : v.scalar;
  }
  kanexpr::mechanics::vector vector(const tree& e) {
    value v = any(e);
    if (!v.is_vector) in_.fail("expected a vector, such as N.x, got a scalar");
    return v.vector;
  }
  /// The value of an expression of numbers.
  double number(const tree& e) {
    const expression found = scalar(e);
    if (in_.wrong().empty() && !found.is_constant()) in_.fail("expected a number");
    return in_.wrong().empty() ? found.owner().number_at(found.node()).value() : 0;
  }

private:
  value any(const tree& e) {
    switch (e.is) {
    case tree::kind::number: return value::of(in_.b.number(e.value));
    case tree::kind::name: return value::of(symbol(e.text));
    case tree::kind::axis: return value::of(axis(e));
    case tree::kind::call: return call(e);
    case tree::kind::negative: return negative(any(e.parts[0]));
    case tree::kind::sum:
    case tree::kind::difference:
    case tree::kind::product:
    case tree::kind::quotient:
    case tree::kind::power: break;
    }
    const value left = any(e.parts[0]), right = any(e.parts[1]);
    return joined(e.is, left, right);
  }

  expression zero() { return in_.b.number(0.0); }
  static value negative(const value& v) { return v.is_vector ? value::of(-v.vector) : value::of(-v.scalar); }

  value joined(tree::kind operation, const value& a, const value& b) {
    if (operation == tree::kind::sum || operation == tree::kind::difference) {
      if (a.is_vector != b.is_vector) return refuse("a vector and a scalar cannot be added");
      const value c = operation == tree::kind::sum ? b : negative(b);
      return a.is_vector ? value::of(a.vector + c.vector) : value::of(a.scalar + c.scalar);
    }
    if (operation == tree::kind::product) {
      if (a.is_vector && b.is_vector) return refuse("the product of two vectors is dot(a, b) or cross(a, b)");
      if (a.is_vector) return value::of(b.scalar * a.vector);
      return b.is_vector ? value::of(a.scalar * b.vector) : value::of(a.scalar * b.scalar);
    }
    if (b.is_vector || (a.is_vector && operation == tree::kind::power))
      return refuse(operation == tree::kind::power ? "vectors have no powers" : "cannot divide by a vector");
    if (operation == tree::kind::power) return value::of(kanexpr::symbolic::power(a.scalar, b.scalar));
    return a.is_vector ? value::of((1 / b.scalar) * a.vector) : value::of(a.scalar / b.scalar);
  }

  value refuse(const std::string& sentence) {
    in_.fail(sentence);
    return value::of(zero());
  }

  expression symbol(const std::string& name) {
    if (name == "pi") return in_.b.number(std::numbers::pi);
    if (name == "t" && !in_.known().contains(name)) return in_.b.time();
    if (in_.known().find<expression>(name) != nullptr) return *in_.known().find<expression>(name);
    in_.fail(in_.known().contains(name) ? name + " is not a scalar" : "unknown symbol " + name);
    return zero();
  }

  kanexpr::mechanics::vector axis(const tree& e) {
    const frame_id frame = in_.frame(e.text);
    return in_.b.along(frame, e.axis == 'x' ? 1 : 0, e.axis == 'y' ? 1 : 0, e.axis == 'z' ? 1 : 0);
  }

  value call(const tree& e) {
    const auto has = [&](std::size_t count) {
      if (e.parts.size() == count) return true;
      in_.fail(e.text + " takes " + std::to_string(count) + (count == 1 ? " argument" : " arguments") +
               ", got " + std::to_string(e.parts.size()));
      return false;
    };
    for (const function_of_one& f : functions_of_one)
      if (f.called == e.text) return value::of(has(1) ? f.of(scalar(e.parts[0])) : zero());
    for (const function_of_two& f : functions_of_two)
      if (f.called == e.text) {
        if (!has(2)) return value::of(zero());
        const expression first = scalar(e.parts[0]), second = scalar(e.parts[1]);
        return value::of(f.of(first, second));
      }
    if (e.text == "dot" && e.parts.size() == 1) return value::of(in_.b.dot(scalar(e.parts[0])));
    if (e.text == "dot" || e.text == "cross") return has(2) ? product(e) : value::of(zero());
    if (e.text == "magnitude") return has(1) ? magnitude(e.parts[0]) : value::of(zero());
    if (e.text == "position_of") return has(2) ? position(e) : value::of(zero());
    if (e.text == "velocity_of" || e.text == "angular_velocity_of")
      return has(1) ? velocity(e) : value::of(zero());
    return refuse("unknown function " + e.text);
  }

  value product(const tree& e) {
    const auto a = vector(e.parts[0]), b = vector(e.parts[1]);
    if (e.text == "dot") return value::of(in_.b.dot(a, b));
    return value::of(kanexpr::derivation::cross(in_.b.mechanism(), a, b));
  }
  value magnitude(const tree& e) {
    const auto v = vector(e);
    return value::of(sqrt(in_.b.dot(v, v)));
  }
  value position(const tree& e) {
    const point_id to = in_.point(e.parts[0].text), from = in_.point(e.parts[1].text);
    return in_.wrong().empty() ? value::of(in_.b.position_of(to, from))
                               : value::of(kanexpr::mechanics::vector{});
  }
  value velocity(const tree& e) {
    if (!in_.has_velocities())
      return refuse(e.text + " is not available in the definitions of frames and points");
    const std::string& name = e.parts[0].text;
    if (e.text == "velocity_of") {
      const point_id p = in_.point(name);
      if (!in_.wrong().empty()) return value::of(kanexpr::mechanics::vector{});
      return value::of(kanexpr::mechanics::velocity_of_point(in_.moving(), kanexpr::runtime::place(p)));
    }
    const frame_id f = in_.frame(name);
    if (!in_.wrong().empty()) return value::of(kanexpr::mechanics::vector{});
    return value::of(kanexpr::mechanics::angular_velocity_of_frame(in_.moving(), kanexpr::runtime::place(f)));
  }

  construction& in_;
};

} // namespace playground
