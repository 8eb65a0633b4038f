#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/entity_reader.hpp>
#include <kanexpr/derivation/read/path_reader.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/loads/loads.hpp>
#include <kanexpr/mechanics/loads/pathway.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/vector.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// A load that is being read: its record, its name in messages, and the values of the parts of the record.
class load_parts : public part_reader {
public:
  const load_record& record;
  mechanics::loads& into;
  const std::string_view whom;

  constexpr load_parts(const part_reader& parts, const load_record& r, mechanics::loads& list,
                       std::string_view called)
      : part_reader(parts), record(r), into(list), whom(called) {}

  constexpr mechanism& model() { return m_; }
  constexpr reading& state() { return reading_; }
  constexpr bool has_mistake() const { return static_cast<bool>(reading_.mistake); }
  constexpr void fail(std::initializer_list<std::string_view> pieces) { reading_.fail(pieces); }

  /// The points or frames between which a load acts; if there is only one, the second is `none`.
  struct ends {
    int first, other;
  };
  constexpr ends points() { return points(whom); }
  constexpr ends points(std::string_view called) {
    const int first = entities_.point(record.point, called);
    return {first, record.other_point != nullptr ? entities_.point(record.other_point, called) : none};
  }
  constexpr ends frames() { return frames(whom); }
  constexpr ends frames(std::string_view called) {
    const int first = entities_.frame(record.frame, called);
    return {first, record.other_frame != nullptr ? entities_.frame(record.other_frame, called) : none};
  }

  /// A scalar, called for example "the stiffness of ".
  constexpr expression scalar(const phrase& p, std::string_view part) {
    return phrases_.scalar_of(p, {part, whom}, whom);
  }
  constexpr mechanics::vector vector(const phrase& p, std::string_view part) {
    return phrases_.vector_of(p, {part, whom}, whom);
  }
  /// An argument of the law of the load.
  constexpr expression term(int i, std::string_view part) { return scalar(record.terms[i], part); }
  constexpr mechanics::pathway path() { return path_reader(*this).read(*record.path, whom); }

  /// The vector of a force or torque. If the load acts on a single entity, messages about the vector name
  /// that entity.
  constexpr mechanics::vector effort(std::string_view place) {
    const load_record& r = record;
    if (r.other_point != nullptr || r.other_frame != nullptr) return vector(r.value, "");
    const std::string_view on = r.point != nullptr ? r.point->called : r.frame->called;
    const sentence load({r.word, place});
    return phrases_.vector_of(r.value, {load.view(), on}, on);
  }
  /// Names a coefficient if its unit does not fit.
  constexpr void expect_unit(const describe::coefficient_record& c, const point_record& at) {
    const expression value = phrases_.scalar_of(c.value, {"", c.word}, c.word);
    base::name word = c.word;
    word.append(" at ");
    if (!reading_.mistake) m_.expected_units.push({value, c.unit, word, at.called});
  }
  constexpr bool holds_bound(const phrase& p) const { return symbols_.holds_bound(p); }
};

} // namespace kanexpr::derivation
