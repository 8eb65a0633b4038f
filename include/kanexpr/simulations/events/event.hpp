#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/out_of_line.hpp>
#include <kanexpr/simulations/settings.hpp>
#include <kanexpr/simulations/system_interface.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace kanexpr {

/// The time of an event and the state, which its handler may change. Dependent coordinates and speeds are
/// solved for afterward.
template <class System>
struct moment {
  const double t;
  state<System>& x;
  const parameter_values<System>& p;
  const input_values<System>& r;
};

/// The action to take when an event occurs: a function of the moment, which may change the state and return
/// whether the simulation stops; or just `after_event::stop`.
template <class System>
class event_handler {
public:
  event_handler() = default;
  event_handler(after_event always) : do_([always](moment<System>&) { return always; }), always_(always) {}
  template <std::invocable<moment<System>&> Handler>
  event_handler(Handler handler)
      : do_([h = std::move(handler)](moment<System>& now) mutable {
          if constexpr (std::is_void_v<std::invoke_result_t<Handler, moment<System>&>>) {
            h(now);
            return after_event::go_on;
          } else {
            return h(now);
          }
        }) {}

  explicit operator bool() const { return static_cast<bool>(do_); }
  /// Returns the constant action, by which a study identifies the handler; empty for a function.
  const std::optional<after_event>& always() const { return always_; }
  after_event operator()(moment<System>& now) const { return do_(now); }

private:
  std::function<after_event(moment<System>&)> do_{};
  std::optional<after_event> always_{};
};

/// An event occurs when a function crosses zero. Without a handler it is only recorded.
template <class System>
struct event {
  using function = std::function<double(double t, const state<System>&, const parameter_values<System>&,
                                        const input_values<System>&)>;

  event(std::string called, function of, crossing passing = crossing::either, event_handler<System> act = {})
      : name(std::move(called)), value(std::move(of)), direction(passing), handler(std::move(act)) {}

  std::string name;
  function value;
  crossing direction;
  event_handler<System> handler;
  std::string text{}; ///< identifies the expression, for a study; empty for a function
};

namespace simulations {

/// The expression of an event.
template <auto expression>
struct watched {
  static constexpr describe::phrase words = describe::phrase_of<expression>;
  static constexpr bool passes_zero =
      words.kind == describe::shape::scalar || words.kind == describe::shape::equation;
  static constexpr base::sentence mistake = [] {
    if (passes_zero) return base::sentence{};
    return base::sentence({"the argument of when<...>", words.size > 0 ? ", with " : "",
                           derivation::name_in(words), words.size > 0 ? "," : "",
                           derivation::is_a(words.kind), "it must be a scalar that can cross zero"});
  }();
  static_assert(derivation::report<watched>());
};

} // namespace simulations

/// Returns the event in which an expression of the model crosses zero or an equation holds: `when<System,
/// dot(position_of<Ball, O>, N::y)>("contact", crossing::falling, bounce)`.
template <class System, auto expression>
event<System> when(std::string name, crossing direction = crossing::either,
                   event_handler<System> handler = {}) {
  using function = out_of_line<kanexpr::function<System, expression>>;
  event<System> found(
      std::move(name),
      [](double t, const state<System>& x, const parameter_values<System>& p,
         const input_values<System>& r) -> double {
        if constexpr (simulations::watched<expression>::passes_zero) return function{}(t, x, p, r);
        return 0;
      },
      direction, std::move(handler));
  if constexpr (simulations::watched<expression>::passes_zero)
    found.text = std::to_string(function::digest());
  return found;
}

} // namespace kanexpr
