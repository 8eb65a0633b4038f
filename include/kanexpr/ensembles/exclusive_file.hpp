#pragma once

#include <kanexpr/base/outcome.hpp>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kanexpr::ensembles {

/// A file that one study at a time may write: while it is claimed, the file PATH.lock next to it is locked.
/// The lock ends with the process, also if that is killed. If no lock file can be created, the file is not
/// locked.
class exclusive_file {
public:
  exclusive_file() = default;
  exclusive_file(const exclusive_file&) = delete;
  exclusive_file& operator=(const exclusive_file&) = delete;
  ~exclusive_file() { release(); }

  outcome claim(const std::string& path) {
    release();
    path_ = path;
    std::error_code none;
    target_ = std::filesystem::absolute(path, none);
    for (int i = 0; i < 40 && std::filesystem::is_symlink(target_, none);
         ++i) // as Linux; it may lead nowhere yet
      target_ = target_.parent_path() / std::filesystem::read_symlink(target_, none);
    const std::filesystem::path folder = std::filesystem::canonical(target_.parent_path(), none);
    if (!none) target_ = folder / target_.filename();
    if (std::filesystem::exists(target_, none) && !std::filesystem::is_regular_file(target_, none)) return {};
    for (bool is_ours = false; !is_ours;) {
      lock_ = ::open(lock_name().c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0666);
      if (lock_ < 0) return {};
      const bool is_taken = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
      struct stat mine = {}, there = {}; // the previous owner may have removed the lock file in the meantime
      is_ours = ::fstat(lock_, &mine) == 0 && ::stat(lock_name().c_str(), &there) == 0 &&
                mine.st_ino == there.st_ino;
      if (is_taken || !is_ours) ::close(lock_), lock_ = -1;
      if (is_taken) return outcome(path_ + " is in use by another study");
    }
    return {};
  }
  void release() {
    if (lock_ >= 0) ::unlink(lock_name().c_str()), ::close(lock_);
    lock_ = -1;
  }

  /// The file itself, by an absolute path without links.
  std::string target() const { return target_.string(); }
  /// A new content, which `replace` moves into place.
  std::string replacement() const { return target() + ".new"; }

  /// Succeeds if the file does not exist or is a regular file.
  outcome check_replaceable(const char* kind) const {
    std::error_code none;
    const auto type = std::filesystem::status(path_, none).type();
    if (path_.ends_with('/') || type == std::filesystem::file_type::directory)
      return outcome(path_ + " is a folder, not " + kind);
    const bool can_be =
        type == std::filesystem::file_type::regular || type == std::filesystem::file_type::not_found;
    return can_be ? outcome() : outcome(path_ + " is not a regular file");
  }
  outcome replace() const {
    return ::rename(replacement().c_str(), target().c_str()) == 0 ? outcome() : failure("cannot be replaced");
  }

  /// Waits until the system has stored a file, so that it survives a power failure.
  outcome sync(const std::string& file) const {
    const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_stored = opened >= 0 && (::fsync(opened) == 0 || errno == EINVAL);
    const outcome done = is_stored ? outcome() : failure("cannot be written");
    if (opened >= 0) ::close(opened);
    return done;
  }

  /// "PATH WHAT: " and the reason that the system gives in errno.
  outcome failure(const char* what) const {
    return outcome(path_ + ' ' + what + ": " + std::generic_category().message(errno));
  }

private:
  std::string lock_name() const { return target() + ".lock"; }

  std::string path_{}; ///< as the user wrote it
  std::filesystem::path target_{};
  int lock_ = -1;
};

} // namespace kanexpr::ensembles
