// A trap for the heap: operator new and malloc count their calls on this thread, and abort under a guard.
#pragma once

#include <cstddef>

namespace no_heap {

// How often this thread has asked for memory so far.
std::size_t allocations() noexcept;

// While one lives, asking for memory on this thread aborts the program there and then.
class guard {
public:
  guard() noexcept;
  ~guard();
  guard(const guard&) = delete;
  guard& operator=(const guard&) = delete;
};

// How often f() asks for memory.
template <class F>
std::size_t allocations_in(F&& f) {
  const std::size_t before = allocations();
  f();
  return allocations() - before;
}

} // namespace no_heap
