#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/operations.hpp>
#include <kanexpr/derivation/read/reading.hpp>
#include <kanexpr/derivation/read/units_of_motion.hpp>
#include <kanexpr/derivation/read/value.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/compose.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/external.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Applies functions of several operands: functions composed of other operations, tables, and user functions.
class call_reader {
public:
  constexpr explicit call_reader(reading& all) : reading_(all), m_(all.into.mechanism) {}

  static constexpr const symbolic::composite_signature& word_of(const describe::token& t) {
    return symbolic::signature_of(static_cast<symbolic::composition>(t.index));
  }

  constexpr void compose(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    const symbolic::composite_signature& f = word_of(t);
    const sequence<expression> operands = operands_of(t, stack, f.name, whom);
    if (reading_.mistake) return;
    const int given = operands.size();
    if (f.operands == symbolic::variadic && !check_table(f, operands, whom)) return;
    if (given != f.operands && f.operands != symbolic::variadic)
      return fail_by_count(f.name, given, f.operands, whom);
    if (f.is == symbolic::composition::clamp && symbolic::are_reversed(operands[1], operands[2]))
      return reading_.fail(
          {reading_.part, whom, " contains clamp with limits out of order; write clamp(x, least, most)"});
    const bool has_width =
        f.is == symbolic::composition::smooth_abs || f.is == symbolic::composition::softplus;
    if (has_width && operands[1].is_constant() && !(m_.g->number_at(operands[1].node()).value() > 0))
      return reading_.fail({reading_.part, whom, " contains ", f.name, " with a width that is not positive"});
    for (int i = 0; i < given; ++i) stack.pop();
    reading_.hides_units = true;
    if (reading_.for_units && f.operands == symbolic::variadic)
      return static_cast<void>(stack.push(value::of(value_of_table(reading_, operands))));
    if (reading_.for_units && !are_numbers(operands))
      return static_cast<void>(stack.push(value::of(value_of_function(reading_, f, operands))));
    stack.push(value::of(symbolic::compose(f.is, operands)));
  }

  /// Calls a user function.
  constexpr void call(const describe::token& t, sequence<value>& stack, std::string_view whom) {
    const describe::external_record& f = *t.external;
    const sequence<expression> operands = operands_of(t, stack, f.called, whom);
    if (reading_.mistake) return;
    if (f.operands != 0) return fail_by_count(f.called, operands.size(), f.operands, whom);
    if (f.function == nullptr)
      return reading_.fail(
          {reading_.part, whom, " calls ", f.called, f.mistake.whose, f.mistake.what, f.mistake.numbers});
    for (const symbolic::external_function* other : m_.g->externals())
      if (other != f.function && other->called == f.function->called)
        return reading_.fail({reading_.part, whom, " calls ", f.called,
                              ", but a different function of the model has the same name"});
    for (int i = 0; i < operands.size(); ++i) stack.pop();
    stack.push(value::of(symbolic::call(*f.function, operands)));
  }

private:
  static constexpr bool are_numbers(const sequence<expression>& operands) {
    for (const expression& e : operands)
      if (!e.is_constant()) return false;
    return true;
  }
  /// Returns the operands of a function, which must be scalars, from the top of the stack.
  constexpr sequence<expression> operands_of(const describe::token& t, const sequence<value>& stack,
                                             std::string_view function, std::string_view whom) {
    sequence<expression> operands;
    for (int i = stack.size() - static_cast<int>(t.number.numerator); i < stack.size(); ++i) {
      if (stack[i].kind != shape::scalar)
        reading_.fail({reading_.part, whom, " applies ", function, " to ", a_kind(stack[i].kind)});
      operands.push(stack[i].scalar);
    }
    return operands;
  }
  constexpr void fail_by_count(std::string_view function, int given, int accepted, std::string_view whom) {
    reading_.fail({reading_.part, whom, " calls ", function, " with ", base::counted(given).view(),
                   given == 1 ? " argument" : " arguments", "; it takes ", base::counted(accepted).view()});
  }

  /// Checks the points of a table, which follow its argument: there must be at least two, in increasing
  /// order, and the last value of a periodic table must equal the first.
  constexpr bool check_table(const symbolic::composite_signature& f, const sequence<expression>& x,
                             std::string_view whom) {
    const int points = (x.size() - 1) / 2;
    const auto say = [&](std::initializer_list<std::string_view> what) {
      const base::sentence rest(what);
      reading_.fail({reading_.part, whom, " contains ", f.name, "<...> ", rest.view()});
    };
    if (x.size() % 2 == 0 || points < 2)
      say({"with ", base::counted(x.size() - 1).view(), x.size() == 2 ? " scalar" : " scalars",
           "; it takes two or more points, each an argument and a value"});
    for (int i = 0; i + 1 < points && !reading_.mistake; ++i) {
      const expression from = x[2 * i + 1], to = x[2 * i + 3];
      if (from.is_constant() && to.is_constant() && !(number_at(from) < number_at(to)))
        say({"whose arguments do not increase at point ", base::counted(i + 2).view()});
    }
    if (!reading_.mistake && f.is == symbolic::composition::periodic && !(x[2] == x.back()))
      say({"whose last value differs from the first"});
    return !reading_.mistake;
  }
  constexpr double number_at(const expression& e) const { return m_.g->number_at(e.node()).value(); }

  reading& reading_;
  mechanism& m_;
};

} // namespace kanexpr::derivation
