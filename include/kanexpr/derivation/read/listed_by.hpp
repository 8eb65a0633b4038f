#pragma once

#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/describe/beam_record.hpp>
#include <kanexpr/describe/flexible_record.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/system.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Finds out which parts of a model list a coordinate or a speed.
class listed_by {
public:
  constexpr listed_by(const describe::system_record& from, const base::name& symbol) : symbol_(symbol) {
    add("the system", "", from.coordinates, from.speeds);
    is_of_part_ = false;
    for (const describe::joint_record& r : from.joints) add("joint ", r.called, r.coordinates, r.speeds);
    for (const describe::body_record& r : from.bodies) {
      if (r.beam != nullptr) add("beam ", r.called, r.beam->coordinates, r.beam->speeds);
      if (r.flexible != nullptr) add("flexible body ", r.called, r.flexible->coordinates, r.flexible->speeds);
    }
  }

  /// ": by the system and by beam B" if a joint or a body lists the symbol; else empty.
  constexpr std::string_view ending() const { return is_of_part_ ? found_.view() : std::string_view(); }

private:
  using symbols = describe::listing<describe::phrase>;

  constexpr void add(std::string_view kind, std::string_view called, const symbols& coordinates,
                     const symbols& speeds) {
    for (const symbols* list : {&coordinates, &speeds})
      for (const describe::phrase& p : *list) {
        if (p.size != 1 || p.tokens[0].symbol == nullptr || p.tokens[0].symbol->called != symbol_) continue;
        found_ = base::sentence({found_.view(), found_ ? " and by " : ": by ", kind, called});
        is_of_part_ = true;
      }
  }

  const base::name& symbol_;
  base::sentence found_{};
  bool is_of_part_ = false;
};

} // namespace kanexpr::derivation
