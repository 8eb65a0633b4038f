#pragma once

#include <kanexpr/derive/read/reader.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/runtime/derived.hpp>

#include <memory>
#include <optional>
#include <utility>

namespace kanexpr::runtime {

/// Derived from a mechanism that was built, of which it keeps a copy.
class derived_from_mechanism final : public derived {
public:
  derived_from_mechanism(std::shared_ptr<symbolic::graph> g, const mechanics::mechanism& built,
                         const mechanics::sentence& mistake)
      : graph_(std::move(g)), mechanism_(built), mistake_(mistake) {
    if (built.derived_by == mechanics::method::lagrange) no_words_.derived_by = describe::method::lagrange;
    if (!mistake_) mistake_ = mechanics::check_mechanism(mechanism_);
    if (mistake_) return;
    equations_.emplace(mechanism_);
    reader_.know(*equations_);
    equations_->constrain();
  }

  const mechanics::sentence& mistake() const override {
    if (mistake_) return mistake_;
    return reader_.mistake() ? reader_.mistake() : equations_->mistake();
  }
  symbolic::graph& graph() override { return *graph_; }
  const mechanics::mechanism& mechanism() const override { return mechanism_; }
  deriving::reader& reader() override { return reader_; }
  mechanics::equations* equations() override { return equations_ ? &*equations_ : nullptr; }

private:
  std::shared_ptr<symbolic::graph> graph_;
  mechanics::mechanism mechanism_;
  mechanics::sentence mistake_;
  describe::system_record no_words_{};
  deriving::reader reader_{no_words_, mechanism_}; ///< of symbols, by their names
  std::optional<mechanics::equations> equations_{};
};

} // namespace kanexpr::runtime
