#pragma once

#include <kanexpr/base/outcome.hpp>
#include <kanexpr/ensembles/archive.hpp>
#include <kanexpr/ensembles/content_hash.hpp>
#include <kanexpr/ensembles/exclusive_file.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace kanexpr::ensembles {

/// The file from which an interrupted study resumes. It is replaced as a whole, so it is always complete.
class checkpoint_file {
  static constexpr std::string_view kind = "kanexpr checkpoint ", header = "kanexpr checkpoint 2\n";

public:
  outcome claim(const std::string& path) {
    path_ = path;
    if (path.empty()) return outcome("the path of the checkpoint is empty");
    if (outcome claimed = file_.claim(path); !claimed) return claimed;
    return file_.check_replaceable("a checkpoint");
  }

  /// Leaves the content empty if there is no file, or an empty one.
  outcome read(std::string& content) const {
    std::ifstream in(file_.target(), std::ios::binary);
    if (!in) return errno == ENOENT ? outcome() : file_.failure("cannot be opened");
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    if (in.bad()) return file_.failure("cannot be read");
    if (whole.empty()) return {};
    if (!whole.starts_with(kind)) return outcome(path_ + " is not a checkpoint of a study");
    if (!whole.starts_with(header)) return of_another_study();
    std::uint64_t expected = 0;
    loader all(std::string_view(whole).substr(header.size()));
    all(expected, content);
    return all.is_at_end() && content_hash(content) == expected ? outcome() : damaged();
  }

  outcome write(const std::string& content) const {
    const std::string name = file_.replacement();
    saver all;
    all(content_hash(content), content);
    std::ofstream out(name, std::ios::binary);
    out << header << all.bytes();
    out.close();
    outcome done = out ? file_.sync(name) : file_.failure("cannot be written");
    if (done) done = file_.replace();
    if (!done) ::unlink(name.c_str());
    return done;
  }

  outcome remove() const {
    return ::unlink(file_.target().c_str()) == 0 || errno == ENOENT ? outcome()
                                                                    : file_.failure("cannot be removed");
  }

  outcome of_another_study() const {
    return outcome(path_ +
                   " belongs to a different study, model or version of kanexpr; remove it to start over");
  }
  outcome damaged() const { return outcome(path_ + " is damaged"); }

private:
  std::string path_{};
  exclusive_file file_{};
};

} // namespace kanexpr::ensembles
