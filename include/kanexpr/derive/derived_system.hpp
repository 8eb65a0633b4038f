#pragma once

#include <kanexpr/derive/image_reader.hpp>
#include <kanexpr/derive/image_writer.hpp>
#include <kanexpr/derive/read/reader.hpp>
#include <kanexpr/mechanics/equations.hpp>

#include <concepts>
#include <optional>

namespace kanexpr::deriving {

/// A system on its way from the types of a model to equations that can be asked for results. It stays where
/// it was made. The first mistake ends the way.
class derived_system {
  // before who calls it: clang++ forms no template for a constant expression that comes later in its class
  template <class Self, class Visit>
  static constexpr void each_part(Self& self, Visit& visit) {
    visit(self.mechanism_);
    visit(self.reader_);
    visit(*self.equations_);
  }

public:
  constexpr explicit derived_system(const system_record& from)
      : mechanism_(graph_), reader_(from, mechanism_) {
    reader_.read();
  }
  /// Goes on where a derivation of the same record was set aside. A template, as `write` is, so that files
  /// which derive nothing do not form what it needs.
  template <std::same_as<image> Image>
  constexpr derived_system(const system_record& from, const Image& aside)
      : mechanism_(graph_), reader_(from, mechanism_) {
    equations_.emplace(mechanism_, mechanics::equations::set_aside{});
    reader_.know(*equations_);
    image_reader read(aside, graph_, mechanism_);
    each_part(*this, read);
  }
  derived_system(const derived_system&) = delete;
  derived_system& operator=(const derived_system&) = delete;

  /// Looks for mistakes in what was read.
  constexpr void check_model() {
    if (!mistake()) mistake_ = mechanics::check_mechanism(mechanism_);
  }

  /// Forms what the equations start from, and takes up loads that speak of motion and the constraints.
  constexpr void derive() {
    if (mistake()) return;
    equations_.emplace(mechanism_);
    reader_.know(*equations_);
    reader_.read_lagrangian();
    if (reader_.read_moving_loads() && !mistake()) mistake_ = mechanics::check_loads(mechanism_);
    reader_.read_constraints();
    if (!mistake()) equations_->constrain();
  }

  /// Sets the derivation aside. Only without a mistake, and after `derive`.
  template <std::same_as<image> Image>
  constexpr void write(Image& into) const {
    image_writer write(into, graph_);
    each_part(*this, write);
  }

  constexpr const sentence& mistake() const {
    if (reader_.mistake()) return reader_.mistake();
    if (mistake_ || !equations_.has_value()) return mistake_;
    return equations_->mistake();
  }

  constexpr bool is_derived() const { return equations_.has_value(); }

  constexpr symbolic::graph& graph() { return graph_; }
  constexpr const symbolic::graph& graph() const { return graph_; }
  constexpr const mechanism& model() const { return mechanism_; }
  constexpr deriving::reader& reader() { return reader_; }

  /// Only without a mistake, and after `derive`.
  constexpr mechanics::equations& equations() { return *equations_; }

private:
  symbolic::graph graph_{};
  mechanism mechanism_;
  deriving::reader reader_;
  sentence mistake_{};
  std::optional<mechanics::equations> equations_{};
};

} // namespace kanexpr::deriving
