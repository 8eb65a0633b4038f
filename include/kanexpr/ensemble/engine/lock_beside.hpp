#pragma once

#include <kanexpr/ensemble/lock_beside.hpp>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kanexpr::ensembles {

KANEXPR_ENSEMBLES std::string end_of_links(const std::string& path) {
  constexpr int most = 40; // as Linux follows
  std::filesystem::path end = path;
  std::error_code none;
  for (int i = 0; i < most && std::filesystem::is_symlink(end, none); ++i)
    end = end.parent_path() / std::filesystem::read_symlink(end, none);
  return end.string();
}

KANEXPR_ENSEMBLES outcome check_replaceable(const std::string& path, const char* kind) {
  struct stat what = {};
  const bool is_folder = path.ends_with('/');
  if (!is_folder && ::stat(path.c_str(), &what) != 0)
    return errno == ENOENT ? outcome()
                           : outcome(path + " cannot be opened: " + std::generic_category().message(errno));
  if (is_folder || S_ISDIR(what.st_mode)) return outcome(path + " is a folder, not " + kind);
  return S_ISREG(what.st_mode) ? outcome() : outcome(path + " is no file that could be replaced");
}

KANEXPR_ENSEMBLES lock_beside::answer lock_beside::hold(const std::string& path) {
  release();
  const std::size_t folders = path.rfind('/') + 1; // 0: it has none
  const std::string folder = folders > 0 ? path.substr(0, folders) : ".";
  name_ = path.substr(folders) + ".lock";
  folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return answer::impossible;
  for (;;) {
    lock_ = ::openat(folder_, name_.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0) return answer::impossible;
    const bool is_held = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    // Its last holder may have removed it meanwhile.
    struct stat mine = {}, there = {};
    const bool is_there = ::fstat(lock_, &mine) == 0 && ::fstatat(folder_, name_.c_str(), &there, 0) == 0 &&
                          mine.st_dev == there.st_dev && mine.st_ino == there.st_ino;
    if (!is_held && is_there) return answer::held;
    ::close(std::exchange(lock_, -1));
    if (is_held) return answer::taken;
  }
}

KANEXPR_ENSEMBLES void lock_beside::release() {
  if (lock_ >= 0) ::unlinkat(folder_, name_.c_str(), 0), ::close(std::exchange(lock_, -1));
  if (folder_ >= 0) ::close(std::exchange(folder_, -1));
}

} // namespace kanexpr::ensembles
