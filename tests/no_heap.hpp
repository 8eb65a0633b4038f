// Detects heap allocation: operator new and malloc count their calls on this thread, and abort while a guard
// exists.
#pragma once

#include <cstddef>

namespace no_heap {

// The number of allocations on this thread so far.
std::size_t allocations() noexcept;

// While an object of this type exists, an allocation on this thread aborts the program.
class guard {
public:
  guard() noexcept;
  ~guard();
  guard(const guard&) = delete;
  guard& operator=(const guard&) = delete;
};

// The number of allocations that f() makes.
template <class F>
std::size_t allocations_in(F&& f) {
  const std::size_t before = allocations();
  f();
  return allocations() - before;
}

} // namespace no_heap
