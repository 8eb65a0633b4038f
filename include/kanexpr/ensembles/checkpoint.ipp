#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/atomic_file.hpp>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace kanexpr::ensembles {

/// The file from which an interrupted study resumes.
class checkpoint_file {
  static constexpr std::string_view kind = "kanexpr checkpoint ", header = "kanexpr checkpoint 3\n";

public:
  explicit checkpoint_file(const std::string& path) : file_(path) {}

  /// Leaves the content empty if the file does not exist or is empty.
  outcome read(std::string& content) const {
    if (outcome checked = file_.check_target(); !checked) return checked;
    std::ifstream in(file_.target(), std::ios::binary);
    if (!in) return errno == ENOENT ? outcome() : file_.failure("cannot be opened");
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    if (in.bad()) return file_.failure("cannot be read");
    if (whole.empty()) return {};
    if (!whole.starts_with(kind)) return outcome(file_.path() + " is not a checkpoint of a study");
    if (!whole.starts_with(header)) return of_another_study();
    content = whole.substr(header.size());
    return {};
  }

  outcome write(const std::string& content) const {
    std::ofstream out(file_.replacement(), std::ios::binary);
    out << header << content;
    out.close();
    outcome done = out ? file_.replace() : file_.failure("cannot be written");
    if (!done) file_.discard_replacement();
    return done;
  }

  outcome remove() const {
    return std::remove(file_.target().c_str()) == 0 || errno == ENOENT ? outcome()
                                                                       : file_.failure("cannot be removed");
  }

  outcome of_another_study() const {
    return outcome(file_.path() +
                   " belongs to a different study, model or version of kanexpr; remove it to start over");
  }
  outcome damaged() const { return outcome(file_.path() + " is damaged"); }

private:
  atomic_file file_;
};

} // namespace kanexpr::ensembles
