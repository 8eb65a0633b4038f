#pragma once

#include <kanexpr/derive/read/reader.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/derived.hpp>

#include <memory>
#include <optional>
#include <utility>

namespace kanexpr::runtime {

/// A system derived from a copy of the builder's system; not derived if `mistake` is set.
class derived_from_builder final : public derived {
public:
  derived_from_builder(std::shared_ptr<symbolic::graph> g, const mechanics::multibody_system& built,
                       const mechanics::sentence& mistake)
      : graph_(std::move(g)), system_(built), mistake_(mistake) {
    if (built.mechanism.derived_by == mechanics::method::lagrange)
      no_words_.derived_by = describe::method::lagrange;
    if (mistake_) return;
    equations_.emplace(system_);
    reader_.know(equations_->known());
    equations_->constrain();
  }

  const mechanics::sentence& mistake() const override {
    if (mistake_) return mistake_;
    return reader_.mistake() ? reader_.mistake() : equations_->mistake();
  }
  symbolic::graph& graph() override { return *graph_; }
  const mechanics::mechanism& mechanism() const override { return system_.mechanism; }
  deriving::reader& reader() override { return reader_; }
  mechanics::equations* equations() override { return equations_ ? &*equations_ : nullptr; }

private:
  std::shared_ptr<symbolic::graph> graph_;
  mechanics::multibody_system system_;
  mechanics::sentence mistake_;
  describe::system_record no_words_{};
  deriving::reader reader_{no_words_, system_}; ///< looks up symbols by name
  std::optional<mechanics::equations> equations_{};
};

} // namespace kanexpr::runtime
