#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/mechanics/checks/check_units.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <optional>

namespace kanexpr::derivation {

/// The units of a model, inferred from those that it states. The model is read separately from its
/// derivation, so that parameters bound to numbers keep their units and the derivation does not depend on
/// units.
class model_units {
public:
  constexpr explicit model_units(const system_record& from) : system_(graph_), reader_(from, system_) {
    reader_.read_for_units();
    if (reader_.mistake()) return;
    inferred_.emplace(system_.mechanism);
    mechanics::system_units(system_, *inferred_).state();
  }
  model_units(const model_units&) = delete;
  model_units& operator=(const model_units&) = delete;

  constexpr sentence mistake() const {
    return inferred_.has_value() ? inferred_->mistake() : reader_.mistake();
  }

private:
  symbolic::graph graph_{};
  mechanics::multibody_system system_;
  reader reader_;
  std::optional<mechanics::unit_inference> inferred_{};
};

} // namespace kanexpr::derivation
