#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensemble/compiled_ensembles.hpp>

#include <string>

namespace kanexpr::ensembles {

/// Where a path leads by links: what stands there is replaced, not a link to it.
KANEXPR_ENSEMBLES std::string end_of_links(const std::string& path);

/// Whether a file may be replaced by another: it is not there, or is a file. What it is for the sentence is
/// `kind`, "a checkpoint".
KANEXPR_ENSEMBLES outcome check_replaceable(const std::string& path, const char* kind);

/// A file beside another one, which only one program holds at a time. It goes with the object, and where a
/// program was killed the next one takes it.
class lock_beside {
public:
  lock_beside() = default;
  lock_beside(const lock_beside&) = delete;
  lock_beside& operator=(const lock_beside&) = delete;
  ~lock_beside() { release(); }

  enum class answer { held, taken, impossible };
  /// `impossible`: the system says why in errno.
  KANEXPR_ENSEMBLES answer hold(const std::string& path);
  KANEXPR_ENSEMBLES void release();

private:
  std::string name_{};
  int folder_ = -1, lock_ = -1; ///< the folder stays the same one where the program changes its own
};

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/lock_beside.hpp>
#endif
