#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensemble/compiled_ensembles.hpp>
#include <kanexpr/ensemble/lock_beside.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace kanexpr::ensembles {

/// A file that is held against other studies, and against other programs which ask, as HDF5 does. They may
/// read it.
class held_file {
public:
  held_file() = default;
  held_file(const held_file&) = delete;
  held_file& operator=(const held_file&) = delete;
  ~held_file() { release(); }

  /// Before it is replaced or changed: it is not there, or may be written and no other program holds it.
  KANEXPR_ENSEMBLES outcome claim(const std::string& path);
  /// Behind that, when it is there.
  KANEXPR_ENSEMBLES outcome hold(const std::string& path);
  /// The bytes from there on, or as many as there are.
  KANEXPR_ENSEMBLES std::string read(std::uint64_t from, std::size_t count) const;
  /// Has the system store what was written, so that it is there also after the machine stopped.
  KANEXPR_ENSEMBLES outcome store() const;
  KANEXPR_ENSEMBLES void release();

private:
  std::string path_{};
  lock_beside lock_{};
  int file_ = -1;
};

} // namespace kanexpr::ensembles

#ifndef KANEXPR_COMPILED_ENSEMBLES
#include <kanexpr/ensemble/engine/held_file.hpp>
#endif
