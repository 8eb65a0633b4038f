#pragma once

#include <kanexpr/base/outcome.hpp>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace kanexpr::ensembles {

/// Returns "PATH WHAT: " followed by the operating system's message for errno.
inline outcome file_failure(const std::string& path, const char* what) {
  return outcome(path + ' ' + what + ": " + std::generic_category().message(errno));
}

/// Waits until the operating system has stored a file, so that it survives a power failure. `called` is the
/// name of the file in error messages.
inline outcome store(const std::string& file, const std::string& called) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_stored = opened >= 0 && (::fsync(opened) == 0 || errno == EINVAL);
  const outcome done = is_stored ? outcome() : file_failure(called, "cannot be written");
  if (opened >= 0) ::close(opened);
  return done;
}

/// A file that is always complete: its new content is written to a replacement next to it, which then takes
/// its place.
class atomic_file {
public:
  explicit atomic_file(std::string path) : path_(std::move(path)), target_(resolved(path_)) {}

  /// Succeeds if the file does not exist or is a regular file.
  outcome check_target() const {
    std::error_code none;
    if (path_.empty()) return outcome("the path of a file is empty");
    return std::filesystem::exists(target_, none) && !std::filesystem::is_regular_file(target_, none)
               ? outcome(path_ + " is not a regular file")
               : outcome();
  }

  /// Returns the absolute path of the file, with links resolved.
  const std::string& target() const { return target_; }
  std::string replacement() const { return target_ + ".new"; }

  /// Moves the replacement into place.
  outcome replace() const {
    if (outcome stored = store(replacement(), path_); !stored) return stored;
    return std::rename(replacement().c_str(), target_.c_str()) == 0 ? outcome()
                                                                    : failure("cannot be replaced");
  }
  void discard_replacement() const { std::remove(replacement().c_str()); }

  outcome failure(const char* what) const { return file_failure(path_, what); }
  /// Returns the path as the user wrote it.
  const std::string& path() const { return path_; }

private:
  static std::string resolved(const std::string& path) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none).string();
  }

  std::string path_, target_;
};

} // namespace kanexpr::ensembles
