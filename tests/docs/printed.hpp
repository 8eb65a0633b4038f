#pragma once

#include <iostream>
#include <sstream>
#include <string>

namespace docs {

/// Captures the output that is printed during its lifetime.
class printed {
public:
  printed() = default;
  printed(const printed&) = delete;
  printed& operator=(const printed&) = delete;
  ~printed() { std::cout.rdbuf(kept_); }

  std::string text() const { return out_.str(); }

private:
  std::ostringstream out_;
  std::streambuf* kept_ = std::cout.rdbuf(out_.rdbuf());
};

} // namespace docs
