#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/flexible/check_numbers.hpp>
#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/options.hpp>
#include <kanexpr/flexible/read_body.hpp>
#include <kanexpr/flexible/sid/reader.hpp>
#include <kanexpr/flexible/sid/translation.hpp>
#include <kanexpr/mechanics/model/flexible_data.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr::flexible {

/// Reads standard input data (SID) from text; `called` names the file in messages.
inline read_body read_sid_text(const std::string& text, const reading_options& options = {},
                               const std::string& called = {}) {
  file_report report(called);
  sid::reader reader(text, report);
  read_body read;
  if (reader.read()) {
    sid::translation translation(reader.document, options, report);
    if (translation.translate() && check_numbers(translation.data, report))
      read.data = std::move(translation.data);
  }
  if (!report.mistake().empty()) read = read_body(report.mistake());
  read.notes = report.notes();
  return read;
}

/// Reads a flexible body from a file with standard input data (SID), as FEMBS and other programs write them.
/// Format: Wallrapp (1994), Standardization of flexible body modeling in multibody system codes.
inline read_body read_sid(const std::string& path, const reading_options& options = {}) {
  return read_file(path, [&](const std::string& text, const std::string& called) {
    return read_sid_text(text, options, called);
  });
}

} // namespace kanexpr::flexible
