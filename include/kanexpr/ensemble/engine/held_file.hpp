#pragma once

#include <kanexpr/ensemble/held_file.hpp>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace kanexpr::ensembles {

inline outcome not_held(const std::string& path, const char* what) {
  return outcome(path + ' ' + what + ": " + std::generic_category().message(errno));
}

inline outcome lock(int file, int how, const std::string& path) {
  if (::flock(file, how | LOCK_NB) == 0 || errno != EWOULDBLOCK) return {}; // or none can be locked there
  return outcome(path + " is open in another program");
}

KANEXPR_ENSEMBLES outcome held_file::claim(const std::string& path) {
  release();
  // Where no file can stand beside it, or it is no file, as /dev/stdout, nothing holds it.
  if (check_replaceable(path, "a file") && lock_.hold(end_of_links(path)) == lock_beside::answer::taken)
    return outcome(path + " is in use by another study");
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0 && errno == ENOENT) return {};
  if (file < 0) return not_held(path, "cannot be opened");
  outcome locked = lock(file, LOCK_EX, path);
  ::close(file);
  return locked;
}

KANEXPR_ENSEMBLES outcome held_file::hold(const std::string& path) {
  if (file_ >= 0) ::close(file_);
  path_ = path;
  file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  return file_ < 0 ? not_held(path, "cannot be opened") : lock(file_, LOCK_SH, path);
}

KANEXPR_ENSEMBLES std::string held_file::read(std::uint64_t from, std::size_t count) const {
  std::string all(count, '\0');
  std::size_t have = 0;
  while (have < count) {
    const auto more = ::pread(file_, all.data() + have, count - have, static_cast<::off_t>(from + have));
    if (more > 0)
      have += static_cast<std::size_t>(more);
    else if (more == 0 || errno != EINTR)
      break;
  }
  all.resize(have);
  return all;
}

KANEXPR_ENSEMBLES outcome held_file::store() const {
  if (::fsync(file_) == 0 || errno == EINVAL) return {}; // or it is nothing that could be stored
  return not_held(path_, "cannot be written");
}

KANEXPR_ENSEMBLES void held_file::release() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  lock_.release();
}

} // namespace kanexpr::ensembles
