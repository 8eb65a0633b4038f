#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/entity_digests.hpp>
#include <kanexpr/derivation/image.hpp>
#include <kanexpr/derivation/model_units.hpp>
#include <kanexpr/derivation/read/reader.hpp>
#include <kanexpr/derivation/request.hpp>
#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/describe/token.hpp>
#include <kanexpr/mechanics/checks/check_units.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/units/unit_inference.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/derived.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace kanexpr::runtime {

KANEXPR_ENGINE void derived::note_linearization(const symbolic::matrix& formed) {
  if (!is_linearization(formed)) linearizations_.push_back(symbolic::nodes_of(formed.entries));
}
KANEXPR_ENGINE bool derived::is_linearization(const symbolic::matrix& m) const {
  const base::sequence<int> nodes = symbolic::nodes_of(m.entries);
  return std::ranges::any_of(linearizations_,
                             [&](const auto& each) { return std::ranges::equal(each, nodes); });
}

/// A system derived from the types of a model.
class derived_from_types final : public derived {
public:
  derived_from_types(const derivation::checked_words& from,
                     std::span<const derivation::request> extra_requests,
                     std::span<const std::uint64_t> expected_digests)
      : mistake_(from.mistake), record_(from.record), system_(from.record) {
    if (mistake_) return;
    if (!expected_digests.empty())
      mistake_ = derivation::entity_digests(from.record).first_difference(expected_digests);
    if (mistake_) return;
    derivation::advance(system_, derivation::stage::constrained);
    derivation::visit(extra_requests, system_.reader());
    states_units_ = system_.reader().states_units();
  }
  derived_from_types(const derived_from_types& same, const derivation::image& from)
      : record_(same.record_), system_(same.record_, from), states_units_(same.states_units_) {}

  const base::sentence& mistake() const override { return mistake_ ? mistake_ : system_.mistake(); }
  symbolic::graph& graph() override { return system_.graph(); }
  const mechanics::multibody_system& system() const override { return system_.system(); }
  derivation::reader& reader() override { return system_.reader(); }
  mechanics::equations* equations() override { return system_.is_derived() ? &system_.equations() : nullptr; }

  bool states_units() const override { return states_units_; }
  mechanics::unit_table units() const override { return derivation::unit_table_of(record_); }
  mechanics::possible_unit unit_of(const symbolic::expression&) const override { return std::nullopt; }
  mechanics::possible_unit unit_of(const describe::phrase& p) const override {
    return derivation::unit_of(record_, p);
  }

  void store(derivation::image& into) override { system_.write(into); }
  std::shared_ptr<derived> resumed(const derivation::image& from) const override {
    return std::make_shared<derived_from_types>(*this, from);
  }

private:
  base::sentence mistake_{}; ///< a mistake in the types themselves
  const describe::system_record& record_;
  derivation::derived_system system_;
  bool states_units_ = false;
};

/// A system derived from a copy of the builder's system; not derived if `mistake` is set.
class derived_from_builder final : public derived {
public:
  derived_from_builder(std::shared_ptr<symbolic::graph> g, const mechanics::multibody_system& built,
                       const base::sentence& mistake)
      : graph_(std::move(g)), system_(built), mistake_(mistake) {
    if (built.mechanism.derived_by == mechanics::method::lagrange)
      no_words_.derived_by = describe::method::lagrange;
    if (mistake_) return;
    equations_.emplace(system_);
    reader_.set_known_motion(equations_->known());
    equations_->constrain();
  }
  derived_from_builder(const derived_from_builder& same, const derivation::image& from)
      : graph_(std::make_shared<symbolic::graph>()), system_(*graph_), no_words_(same.no_words_) {
    equations_.emplace(system_, mechanics::equations::for_restore{});
    reader_.set_known_motion(equations_->known());
    derivation::image_transfer read(from, *graph_, system_.mechanism);
    each_part(read);
  }

  const base::sentence& mistake() const override {
    if (mistake_) return mistake_;
    return reader_.mistake() ? reader_.mistake() : equations_->mistake();
  }
  symbolic::graph& graph() override { return *graph_; }
  const mechanics::multibody_system& system() const override { return system_; }
  derivation::reader& reader() override { return reader_; }
  mechanics::equations* equations() override { return equations_ ? &*equations_ : nullptr; }

  bool states_units() const override { return !system_.mechanism.stated_units.empty(); }
  mechanics::unit_table units() const override { return mechanics::unit_table_of(system_); }
  mechanics::possible_unit unit_of(const symbolic::expression& e) const override {
    if (!states_units()) return std::nullopt;
    mechanics::unit_inference inferred(system_.mechanism);
    mechanics::system_units(system_, inferred).state();
    return inferred.unit_of(e);
  }
  mechanics::possible_unit unit_of(const describe::phrase&) const override { return std::nullopt; }

  void store(derivation::image& into) override {
    derivation::image_transfer write(into, *graph_);
    each_part(write);
  }
  std::shared_ptr<derived> resumed(const derivation::image& from) const override {
    return std::make_shared<derived_from_builder>(*this, from);
  }

private:
  void each_part(derivation::image_transfer& visit) {
    visit(system_);
    visit(reader_);
    visit(*equations_);
  }

  std::shared_ptr<symbolic::graph> graph_;
  mechanics::multibody_system system_;
  base::sentence mistake_{};
  describe::system_record no_words_{};
  derivation::reader reader_{no_words_, system_}; ///< looks up symbols by name
  std::optional<mechanics::equations> equations_{};
};

} // namespace kanexpr::runtime
