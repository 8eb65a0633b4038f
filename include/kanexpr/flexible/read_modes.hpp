#pragma once

#include <kanexpr/flexible/agreement.hpp>
#include <kanexpr/flexible/check_numbers.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/modes/integrals_of_modes.hpp>
#include <kanexpr/flexible/modes/reader.hpp>
#include <kanexpr/flexible/options.hpp>
#include <kanexpr/flexible/read_body.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>

namespace kanexpr::flexible {

namespace detail {

/// Whether the given modal mass agrees with the one of the shapes.
inline bool has_modal_mass(const mechanics::flexible_data& d, const modes::reader& from,
                           const reading_options& options, file_report& report) {
  const modes::modal_model::matrix& given = from.model.modal_mass;
  comparison mass;
  for (std::size_t i = 0; i < given.size(); ++i) mass.add(given[i], d.modal_mass[static_cast<int>(i)]);
  const auto name = [&](std::size_t e) {
    const int place = static_cast<int>(e);
    return "modal_mass[" + std::to_string(place / d.amplitudes) + "][" +
           std::to_string(place % d.amplitudes) + "]";
  };
  return agrees(mass, 0, name, "the masses and the shapes give", options, report);
}

/// Completes the stiffness and the damping that are given by frequencies and damping ratios, and replaces the
/// modal mass of the shapes by the given one unless the derived one is preferred.
inline void complete_modes(mechanics::flexible_data& d, const modes::reader& from, bool prefers_derived) {
  const int n = d.amplitudes;
  for (int i = 0; i < d.modal_mass.size() && !from.model.modal_mass.empty() && !prefers_derived; ++i)
    d.modal_mass[i] = from.model.modal_mass[static_cast<std::size_t>(i)];
  for (int k = 0; k < n; ++k) {
    const int place = k * n + k;
    const auto index = static_cast<std::size_t>(k);
    if (!from.frequencies.empty()) {
      const double rate = 2 * std::numbers::pi * from.frequencies[index];
      d.stiffness[place] = rate * rate * d.modal_mass[place];
    }
    if (!from.ratios.empty())
      d.damping[place] = 2 * from.ratios[index] * std::sqrt(d.stiffness[place] * d.modal_mass[place]);
  }
}

} // namespace detail

/// Reads the modes of a finite-element model from text in JSON; `called` names the file in messages.
inline read_body read_modes_text(const std::string& text, const reading_options& options = {},
                                 const std::string& called = {}) {
  file_report report(called);
  modes::reader reader(report);
  read_body read;
  if (reader.read(text)) {
    read.data = modes::integrals_of_modes(reader.model).data();
    if (detail::has_modal_mass(read.data, reader, options, report)) {
      detail::complete_modes(read.data, reader, options.prefer_derived);
      check_numbers(read.data, report);
    }
  }
  if (!report.mistake().empty()) read = read_body(report.mistake());
  read.notes = report.notes();
  return read;
}

/// Reads the modes of a finite-element model from a JSON file. Its keys are described in
/// docs/guide/flexible-body-files.md.
inline read_body read_modes(const std::string& path, const reading_options& options = {}) {
  return read_file(path, [&](const std::string& text, const std::string& called) {
    return read_modes_text(text, options, called);
  });
}

} // namespace kanexpr::flexible
