#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/check_contents.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The context in which a load is checked: the contents of expressions, the names of points and frames, and
/// the first mistake.
class load_check {
public:
  constexpr load_check(const mechanism& m, const contents& held) : m_(m), held_(held) {}

  constexpr const sentence& mistake() const { return found_; }
  constexpr const mechanism& mechanism_used() const { return m_; }

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!found_) found_ = sentence(pieces);
  }

  constexpr std::string_view frame(int f) const { return m_.frames[f].called.view(); }
  constexpr std::string_view point(int p) const { return m_.points[p].called.view(); }
  /// Returns the two points or frames between which a load acts: "P and Q".
  template <class Load>
  constexpr sentence ends_of(const Load& load) const {
    if constexpr (requires { load.point; })
      return sentence({point(load.point), " and ", point(load.against)});
    else
      return sentence({frame(load.frame), " and ", frame(load.against)});
  }
  /// Returns the place where a load acts: "at P", "on A", "between P and Q".
  template <class Load>
  constexpr sentence place_of(const Load& load) const {
    if (load.against != none) return sentence({"between ", ends_of(load).view()});
    if constexpr (requires { load.point; })
      return sentence({"at ", point(load.point)});
    else
      return sentence({"on ", frame(load.frame)});
  }

  /// Checks an expression that may contain anything except rates of speeds. `of` and `whose` name it, as in
  /// "the force at " and "P".
  constexpr void check_no_speed_rates(expression e, std::string_view of, std::string_view whose) {
    if (const sentence found = symbol_in(m_, held_, e, {kind::speed_rate}))
      fail({of, whose, " contains the ", found.view()});
  }
  constexpr void check_no_speed_rates(const vector& v, std::string_view of, std::string_view whose) {
    v.each_entry([&](expression e) { check_no_speed_rates(e, of, whose); });
  }

  /// Checks an expression that may contain only coordinates, parameters, inputs and time.
  constexpr void check_no_rates(expression e, std::string_view of, std::string_view whose) {
    if (!found_) found_ = mechanics::check_no_rates(m_, held_, e, of, whose);
  }

  /// Checks a quantity that would contribute an additional force if it depended on coordinates.
  constexpr void check_constant(expression e, std::string_view of, std::string_view whose) {
    fail_varying(symbol_in(m_, held_, e, {kind::coordinate}), of, whose);
    check_constant_rates(e, of, whose);
  }
  constexpr void check_constant_rates(expression e, std::string_view of, std::string_view whose) {
    fail_varying(symbol_in(m_, held_, e,
                           {kind::auxiliary_speed, kind::coordinate_rate, kind::speed, kind::speed_rate}),
                 of, whose);
  }
  /// Reports a symbol that a quantity contains but must not contain; does nothing if `symbol` is empty.
  constexpr void fail_varying(const sentence& symbol, std::string_view of, std::string_view whose) {
    if (symbol)
      fail({of, whose, " contains the ", symbol.view(), "; it may contain only parameters, inputs and time"});
  }

private:
  using kind = symbolic::symbol_kind;

  const mechanism& m_;
  const contents& held_;
  sentence found_{};
};

} // namespace kanexpr::mechanics
