#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/checkpoint.hpp>
#include <kanexpr/ensemble/sum_of_bytes.hpp>

#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace kanexpr::ensembles {

inline constexpr std::string_view kind_of_note = "kanexpr checkpoint 1\n";

inline outcome checkpoint_file::failed(const char* what) const {
  return outcome(path_ + ' ' + what + ": " + std::generic_category().message(errno));
}

KANEXPR_ENSEMBLES outcome checkpoint_file::hold(const std::string& path) {
  if (path.empty()) return outcome("the path of the checkpoint is empty");
  path_ = path;
  if (outcome fits = check_replaceable(path, "a checkpoint"); !fits) return fits;
  const std::string end = end_of_links(path);
  const std::size_t folders = end.rfind('/') + 1; // 0: it has none
  name_ = end.substr(folders);
  const std::string folder = folders > 0 ? end.substr(0, folders) : ".";
  folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return failed("cannot be written");
  // A file beside it is locked, as it is itself replaced by each note.
  switch (lock_.hold(end)) {
  case lock_beside::answer::held: return {};
  case lock_beside::answer::taken: return outcome(path_ + " is in use by another study");
  case lock_beside::answer::impossible: break;
  }
  return failed("cannot be written");
}

KANEXPR_ENSEMBLES checkpoint_file::~checkpoint_file() {
  if (folder_ >= 0) ::close(folder_);
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

} // namespace kanexpr::ensembles
