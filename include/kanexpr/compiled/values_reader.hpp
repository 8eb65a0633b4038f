#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/base/sentence.hpp>
#include <kanexpr/compiled/symbol_range.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/symbol_name.hpp>
#include <kanexpr/describe/system.hpp>

#include <array>
#include <initializer_list>
#include <string_view>

namespace kanexpr::compiled {

/// Checks the parameters of a system for negative masses, impossible inertias, and impossible values of
/// loads, such as negative stiffnesses. Returns a message that names the first one; empty if there is none.
/// Parameters that are NaN are treated as unknown.
base::sentence check_masses(const derivation::survey& known, const double* parameters);

/// Stores values specified by name at their indices and keeps the first mistake. A model derived at run time
/// does not have a name, so its messages read "the model has no parameter ll".
class values_reader {
public:
  values_reader(const derivation::survey& known, const describe::system_record& told, std::string_view system,
                const symbol_range& range, double* values)
      : known_(known), told_(told), system_(system), range_(range), values_(values) {}

  void read(const symbol_name& what, double value);
  /// Checks that every symbol has a value, except those that may be omitted.
  void check_missing();
  void check_finite();
  /// Checks masses and inertias.
  void check_physical();

  bool is_named(int i) const { return named_[static_cast<std::size_t>(i)]; }
  const base::sentence& mistake() const { return mistake_; }

private:
  int place_of(std::string_view name) const;
  bool is_bound(std::string_view name) const;
  void fail(std::initializer_list<std::string_view> pieces);

  const derivation::survey& known_;
  const describe::system_record& told_;
  std::string_view system_;
  symbol_range range_;
  double* values_;
  std::array<bool, derivation::survey::room> named_{};
  base::sentence mistake_{};
};

} // namespace kanexpr::compiled

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/compiled/values_reader.ipp>
#endif
