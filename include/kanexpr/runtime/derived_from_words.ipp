#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/entity_digests.hpp>
#include <kanexpr/derivation/request.hpp>
#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/runtime/derived.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <memory>
#include <span>

namespace kanexpr::runtime {

/// A system derived from the words of a model.
class derived_from_words final : public derived {
public:
  derived_from_words(const derivation::checked_words& from, std::span<const derivation::request> also,
                     std::span<const std::uint64_t> meant)
      : mistake_(from.mistake), record_(from.record), system_(from.record) {
    if (mistake_) return;
    if (!meant.empty()) mistake_ = derivation::entity_digests(from.record).unlike(meant);
    if (mistake_) return;
    derivation::go_on(system_, derivation::stage::constrained);
    derivation::visit(also, system_.reader());
  }
  derived_from_words(const describe::system_record& record, const derivation::image& from)
      : record_(record), system_(record, from) {}

  const base::sentence& mistake() const override { return mistake_ ? mistake_ : system_.mistake(); }
  symbolic::graph& graph() override { return system_.graph(); }
  const mechanics::mechanism& mechanism() const override { return system_.mechanism(); }
  derivation::reader& reader() override { return system_.reader(); }
  mechanics::equations* equations() override { return system_.is_derived() ? &system_.equations() : nullptr; }

  void store(derivation::image& into) const override { system_.write(into); }
  std::shared_ptr<derived> resumed(const derivation::image& from) const override {
    return std::make_shared<derived_from_words>(record_, from);
  }

private:
  base::sentence mistake_{}; ///< a mistake in the words themselves
  const describe::system_record& record_;
  derivation::derived_system system_;
};

} // namespace kanexpr::runtime
