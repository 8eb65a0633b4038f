#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/describe/token.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <memory>
#include <vector>

namespace kanexpr {

namespace mechanics {
class equations;
}
namespace derivation {
class reader;
struct image;
} // namespace derivation

namespace runtime {

/// A system derived at run time, from any source. It cannot be copied or moved, because expressions refer to
/// it.
class derived {
public:
  derived() = default;
  derived(const derived&) = delete;
  derived& operator=(const derived&) = delete;
  virtual ~derived() = default;

  virtual const base::sentence& mistake() const = 0;
  virtual symbolic::graph& graph() = 0;
  virtual const mechanics::multibody_system& system() const = 0;
  virtual derivation::reader& reader() = 0;
  /// The equations of motion; null if a mistake was found before they were derived.
  virtual mechanics::equations* equations() = 0;

  /// Whether the model states the unit of any symbol.
  virtual bool states_units() const = 0;
  /// The units of the symbols and constraints.
  virtual mechanics::unit_table units() const = 0;
  /// The unit of an expression that a builder formed, or of a phrase of the types of a model; nothing if it
  /// is undetermined.
  virtual mechanics::possible_unit unit_of(const symbolic::expression& e) const = 0;
  virtual mechanics::possible_unit unit_of(const describe::phrase& p) const = 0;

  /// Stores the derivation. Requires that there is no mistake.
  virtual void store(derivation::image& into) = 0;
  /// The same system in a separate graph, resumed from the stored derivation.
  virtual std::shared_ptr<derived> resumed(const derivation::image& from) const = 0;

  /// Notes a matrix of the linearized equations.
  void note_linearization(const symbolic::matrix& formed);
  /// Whether a matrix was noted. A function that evaluates it reports every entry that is not finite.
  bool is_linearization(const symbolic::matrix& m) const;

  /// The mistake in the last request, not in the system itself.
  base::sentence request_mistake{};

private:
  std::vector<base::sequence<int>> linearizations_{}; ///< the nodes of their entries, row by row
};

} // namespace runtime

} // namespace kanexpr
