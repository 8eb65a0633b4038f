#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/mechanics/checks/check_units.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <optional>

namespace kanexpr::derivation {

using mechanics::possible_unit;

/// The units of a model, inferred from those that it states. The model is read separately from its
/// derivation, so that parameters bound to numbers keep their units and the derivation does not depend on
/// units.
class model_units {
public:
  constexpr explicit model_units(const system_record& from)
      : system_(graph_), reader_(from, system_), inferred_(system_.mechanism) {
    reader_.read_for_units();
    is_read_ = !reader_.mistake();
    if (is_read_) mechanics::system_units(system_, inferred_).state();
  }
  model_units(const model_units&) = delete;
  model_units& operator=(const model_units&) = delete;

  /// The first mistake, also in a phrase whose unit was requested.
  constexpr sentence mistake() const { return is_read_ ? inferred_.mistake() : reader_.mistake(); }

  constexpr mechanics::unit_table table() {
    if (!is_read_) return {};
    return mechanics::unit_table_of(system_, inferred_);
  }

  /// The unit of a scalar or of the components of a vector; nothing if it is not determined.
  constexpr possible_unit unit_of(const phrase& p) {
    if (!is_read_ || system_.mechanism.stated_units.empty()) return std::nullopt;
    reader_.visit(p.tokens, p.size);
    const value v = reader_.evaluate(p, "an expression");
    if (reader_.mistake()) {
      reader_.forget_mistake();
      return std::nullopt;
    }
    if (v.kind == shape::scalar) return inferred_.unit_of(v.scalar);
    possible_unit found;
    v.vector.each_entry([&](expression e) {
      if (!found.has_value()) found = inferred_.unit_of(e);
    });
    return found;
  }

private:
  symbolic::graph graph_{};
  mechanics::multibody_system system_;
  reader reader_;
  mechanics::unit_inference inferred_;
  bool is_read_ = false;
};

/// The units of the symbols and constraints of a model.
constexpr mechanics::unit_table unit_table_of(const system_record& from) {
  model_units units(from);
  return units.table();
}

/// The unit of a phrase of a model.
constexpr possible_unit unit_of(const system_record& from, const phrase& p) {
  model_units units(from);
  return units.unit_of(p);
}

} // namespace kanexpr::derivation
