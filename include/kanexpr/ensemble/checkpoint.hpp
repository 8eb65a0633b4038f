#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/lock_beside.hpp>

#include <optional>
#include <string>
#include <utility>

namespace kanexpr::ensembles {

/// What was noted of a study, or why it cannot be read.
struct noted : outcome {
  std::optional<std::string> content{}; ///< none: there is no file, or nothing in it
  noted() = default;
  explicit noted(outcome failed) : outcome(std::move(failed)) {}
};

/// The file in which a study is noted, held against other studies as long as the object lives. It stays the
/// same one where the program changes its folder.
class checkpoint_file {
public:
  checkpoint_file() = default;
  checkpoint_file(const checkpoint_file&) = delete;
  checkpoint_file& operator=(const checkpoint_file&) = delete;
  KANEXPR_ENSEMBLES ~checkpoint_file();

  /// Once, before all else.
  KANEXPR_ENSEMBLES outcome hold(const std::string& path);
  KANEXPR_ENSEMBLES noted read() const;
  /// Replaces it by another content, whole or not at all, also if the machine stops meanwhile.
  KANEXPR_ENSEMBLES outcome write(const std::string& content) const;
  KANEXPR_ENSEMBLES outcome remove() const;

private:
  outcome failed(const char* what) const;

  std::string path_{}, name_{}; ///< as it was given, and in its folder
  int folder_ = -1;
  lock_beside lock_{};
};

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/checkpoint.hpp>
#endif
