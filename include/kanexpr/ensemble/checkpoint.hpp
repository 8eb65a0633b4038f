#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensemble/compiled_ensembles.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace kanexpr::ensembles {

/// What was noted of a study, or why it cannot be read.
struct noted : outcome {
  std::optional<std::string> content{}; ///< none: there is no file
  noted() = default;
  explicit noted(outcome failed) : outcome(std::move(failed)) {}
};

/// Replaces a file by another content, whole or not at all, also if the machine stops meanwhile.
KANEXPR_ENSEMBLES outcome note(const std::string& path, const std::string& content);
KANEXPR_ENSEMBLES noted read_note(const std::string& path);
KANEXPR_ENSEMBLES outcome remove_note(const std::string& path);

/// A number that is another one for nearly all other contents.
KANEXPR_ENSEMBLES std::uint64_t sum_of(std::string_view content);

/// By what a program is known again: a number formed of its file; 0 where that cannot be read.
KANEXPR_ENSEMBLES std::uint64_t this_program();

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/checkpoint.hpp>
#endif
