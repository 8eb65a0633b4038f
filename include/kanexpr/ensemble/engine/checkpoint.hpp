#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensemble/checkpoint.hpp>
#include <kanexpr/ensemble/random_number.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include <fcntl.h>
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

inline outcome failed(const std::string& path, const char* what) {
  return outcome(path + ' ' + what + ": " + std::generic_category().message(errno));
}

inline constexpr std::string_view kind_of_note = "kanexpr checkpoint 1\n";

KANEXPR_ENSEMBLES outcome note(const std::string& path, const std::string& content) {
  const std::string beside = path + ".new";
  const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return failed(beside, "cannot be written");
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
  outcome done = is_sound ? outcome() : failed(beside, "cannot be written");
  if (::close(file) != 0 && done) done = failed(beside, "cannot be written");
  if (done && std::rename(beside.c_str(), path.c_str()) != 0) done = failed(path, "cannot be replaced");
  if (!done) ::unlink(beside.c_str());
  return done;
}

KANEXPR_ENSEMBLES noted read_note(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    if (errno == ENOENT) return {};
    return noted(failed(path, "cannot be opened"));
  }
  std::string content(std::istreambuf_iterator<char>(in), {});
  if (!content.starts_with(kind_of_note)) return noted(outcome(path + " is not a checkpoint of a study"));
  content.erase(0, kind_of_note.size());
  bytes_reader sum(content);
  const auto told = sum.get<std::uint64_t>();
  content.erase(0, sizeof told);
  if (!sum || told != sum_of(content)) return noted(outcome(path + " is damaged"));
  noted found;
  found.content = std::move(content);
  return found;
}

KANEXPR_ENSEMBLES outcome remove_note(const std::string& path) {
  if (std::remove(path.c_str()) == 0 || errno == ENOENT) return {};
  return failed(path, "cannot be removed");
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
