#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/check_stillness.hpp>
#include <kanexpr/mechanics/model/contents.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The context for system_checker a load: the contents of expressions, the names of points and frames, and
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
  constexpr sentence both_frames(int f, int other) const {
    return sentence({frame(f), " and ", frame(other)});
  }
  constexpr sentence both_points(int p, int other) const {
    return sentence({point(p), " and ", point(other)});
  }

  /// Checks an expression that may contain anything except rates of speeds. `of` and `whose` name it, as in
  /// "the force at " and "P".
  constexpr void free_of_speed_rates(expression e, std::string_view of, std::string_view whose) {
    if (held_.holds(e, kind::speed_rate))
      fail({of, whose, " contains the ", speed_rate_called(m_, held_.name_of(e, kind::speed_rate)).view()});
  }
  constexpr void free_of_speed_rates(const vector& v, std::string_view of, std::string_view whose) {
    for (const vector::part& part : v.parts)
      for (int i = 0; i < 3; ++i) free_of_speed_rates(part.value[i], of, whose);
  }

  /// Checks an expression that may contain only coordinates, parameters, inputs and time.
  constexpr void free_of_motion(expression e, std::string_view of, std::string_view whose) {
    if (!found_) found_ = check_stillness(m_, held_, e, of, whose);
  }

  /// Checks a quantity that would contribute an additional force if it depended on coordinates.
  constexpr void constant_in_motion(expression e, std::string_view of, std::string_view whose) {
    if (held_.holds(e, kind::coordinate))
      varies(of, whose, sentence({"coordinate ", held_.name_of(e, kind::coordinate)}));
    free_of_rates(e, of, whose);
  }
  constexpr void free_of_rates(expression e, std::string_view of, std::string_view whose) {
    struct word {
      kind what;
      std::string_view called;
    };
    for (const word& w : {word{kind::auxiliary_speed, "auxiliary speed "},
                          word{kind::coordinate_rate, "rate of coordinate "}})
      if (held_.holds(e, w.what)) varies(of, whose, sentence({w.called, held_.name_of(e, w.what)}));
    if (held_.holds(e, kind::speed)) varies(of, whose, speed_called(m_, held_.name_of(e, kind::speed)));
    if (held_.holds(e, kind::speed_rate))
      varies(of, whose, speed_rate_called(m_, held_.name_of(e, kind::speed_rate)));
  }
  constexpr void varies(std::string_view of, std::string_view whose, const sentence& with) {
    fail({of, whose, " contains the ", with.view(), "; it may contain only parameters, inputs and time"});
  }

private:
  using kind = symbolic::symbol_kind;

  const mechanism& m_;
  const contents& held_;
  sentence found_{};
};

} // namespace kanexpr::mechanics
