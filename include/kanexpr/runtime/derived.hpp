#pragma once

#include <kanexpr/base/sentence.hpp>

namespace kanexpr {

namespace symbolic {
class graph;
}
namespace mechanics {
struct mechanism;
class equations;
} // namespace mechanics
namespace deriving {
class reader;
}

namespace runtime {

/// A system that was derived while the program runs, wherever it comes from. It stays where it was made:
/// expressions refer to it.
class derived {
public:
  derived() = default;
  derived(const derived&) = delete;
  derived& operator=(const derived&) = delete;
  virtual ~derived() = default;

  virtual const mechanics::sentence& mistake() const = 0;
  virtual symbolic::graph& graph() = 0;
  virtual const mechanics::mechanism& mechanism() const = 0;
  virtual deriving::reader& reader() = 0;
  /// Null where a mistake came before them.
  virtual mechanics::equations* equations() = 0;

  /// What is wrong with the last request alone; the system is sound.
  mechanics::sentence refused{};
};

} // namespace runtime

} // namespace kanexpr
