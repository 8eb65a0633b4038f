#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/checkpoint.hpp>
#include <kanexpr/ensemble/random_number.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kanexpr::ensembles {

KANEXPR_ENSEMBLES std::uint64_t sum_of(std::string_view content) {
  std::uint64_t sum = content.size();
  while (!content.empty()) {
    std::uint64_t word = 0;
    const std::size_t count = (std::min)(content.size(), sizeof word);
    std::memcpy(&word, content.data(), count);
    sum = mixed((sum << 1 | sum >> 63) ^ mixed(word + 0x9e3779b97f4a7c15));
    content.remove_prefix(count);
  }
  return sum;
}

inline constexpr std::string_view kind_of_note = "kanexpr checkpoint 1\n";

/// Where a path leads by links: what stands there is replaced, not a link to it.
inline std::string end_of_links(const std::string& path) {
  constexpr int most = 40; // as Linux follows
  std::filesystem::path end = path;
  std::error_code none;
  for (int i = 0; i < most && std::filesystem::is_symlink(end, none); ++i)
    end = end.parent_path() / std::filesystem::read_symlink(end, none);
  return end.string();
}

inline outcome checkpoint_file::failed(const char* what) const {
  return outcome(path_ + ' ' + what + ": " + std::generic_category().message(errno));
}

KANEXPR_ENSEMBLES outcome checkpoint_file::hold(const std::string& path) {
  if (path.empty()) return outcome("the path of the checkpoint is empty");
  path_ = path;
  const std::string end = end_of_links(path);
  const std::size_t folders = end.rfind('/') + 1; // 0: it has none
  name_ = end.substr(folders);
  const std::string folder = folders > 0 ? end.substr(0, folders) : ".";
  folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return failed("cannot be written");
  if (outcome fits = check_kind(); !fits) return fits;
  // A file beside it is locked, as it is itself replaced by each note. The lock goes with the program; the
  // file goes with the study, and where it stays, the next study takes it.
  for (;;) {
    lock_ = ::openat(folder_, lock_name().c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0) return failed("cannot be written");
    const bool is_held = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    struct stat mine = {}, there = {};
    const bool is_there = ::fstat(lock_, &mine) == 0 &&
                          ::fstatat(folder_, lock_name().c_str(), &there, 0) == 0 &&
                          mine.st_dev == there.st_dev && mine.st_ino == there.st_ino;
    if (!is_held && is_there) return {};
    ::close(std::exchange(lock_, -1));
    if (is_held) return outcome(path_ + " is in use by another study");
  }
}

KANEXPR_ENSEMBLES checkpoint_file::~checkpoint_file() {
  if (lock_ >= 0) ::unlinkat(folder_, lock_name().c_str(), 0), ::close(lock_);
  if (folder_ >= 0) ::close(folder_);
}

inline outcome checkpoint_file::check_kind() const {
  struct stat what = {};
  if (!name_.empty() && ::fstatat(folder_, name_.c_str(), &what, 0) != 0)
    return errno == ENOENT ? outcome() : failed("cannot be opened");
  if (name_.empty() || S_ISDIR(what.st_mode)) return outcome(path_ + " is a folder, not a checkpoint");
  return S_ISREG(what.st_mode) ? outcome() : outcome(path_ + " is no file that could be replaced");
}

KANEXPR_ENSEMBLES outcome checkpoint_file::write(const std::string& content) const {
  const std::string beside = name_ + ".new";
  const int file = ::openat(folder_, beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return failed("cannot be written");
  bytes_writer sum;
  sum.put(sum_of(content));
  const std::string whole = std::string(kind_of_note) + sum.bytes() + content;
  bool is_sound = true;
  for (std::size_t at = 0; is_sound && at < whole.size();) {
    const auto count = ::write(file, whole.data() + at, whole.size() - at);
    if (count > 0)
      at += static_cast<std::size_t>(count);
    else
      is_sound = count < 0 && errno == EINTR;
  }
  is_sound = is_sound && ::fsync(file) == 0;
  outcome done = is_sound ? outcome() : failed("cannot be written");
  if (::close(file) != 0 && done) done = failed("cannot be written");
  if (done && ::renameat(folder_, beside.c_str(), folder_, name_.c_str()) != 0)
    done = failed("cannot be replaced");
  if (!done) ::unlinkat(folder_, beside.c_str(), 0);
  return done;
}

KANEXPR_ENSEMBLES noted checkpoint_file::read() const {
  const int file = ::openat(folder_, name_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return errno == ENOENT ? noted() : noted(failed("cannot be opened"));
  std::string content;
  ::ssize_t count = 0;
  char some[16384];
  while ((count = ::read(file, some, sizeof some)) > 0 || (count < 0 && errno == EINTR))
    if (count > 0) content.append(some, static_cast<std::size_t>(count));
  const outcome done = count < 0 ? failed("cannot be read") : outcome();
  ::close(file);
  if (!done) return noted(done);
  if (content.empty()) return {}; // as mktemp makes one
  if (!content.starts_with(kind_of_note)) return noted(outcome(path_ + " is not a checkpoint of a study"));
  content.erase(0, kind_of_note.size());
  bytes_reader sum(content);
  const auto told = sum.get<std::uint64_t>();
  const bool is_whole = static_cast<bool>(sum);
  if (is_whole) content.erase(0, sizeof told);
  if (!is_whole || told != sum_of(content)) return noted(outcome(path_ + " is damaged"));
  noted found;
  found.content = std::move(content);
  return found;
}

KANEXPR_ENSEMBLES outcome checkpoint_file::remove() const {
  return ::unlinkat(folder_, name_.c_str(), 0) == 0 || errno == ENOENT ? outcome()
                                                                       : failed("cannot be removed");
}

KANEXPR_ENSEMBLES std::uint64_t this_program() {
  static const std::uint64_t sum = [] {
    std::ifstream in("/proc/self/exe", std::ios::binary);
    std::ostringstream content;
    if (in) content << in.rdbuf();
    return in ? sum_of(content.view()) : 0;
  }();
  return sum;
}

} // namespace kanexpr::ensembles
