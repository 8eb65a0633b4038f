#pragma once

#include <ios>
#include <iostream>
#include <sstream>
#include <string>

namespace docs {

/// Captures the output that is printed during its lifetime, and then restores the format of std::cout.
class printed {
public:
  printed() { format_.copyfmt(std::cout); }
  printed(const printed&) = delete;
  printed& operator=(const printed&) = delete;
  ~printed() {
    std::cout.rdbuf(kept_);
    std::cout.copyfmt(format_);
  }

  std::string text() const { return out_.str(); }

private:
  std::ios format_{nullptr};
  std::ostringstream out_;
  std::streambuf* kept_ = std::cout.rdbuf(out_.rdbuf());
};

} // namespace docs
