#include "no_heap.hpp"

#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t count = 0;
thread_local int guards = 0;

void note() noexcept {
  ++count;
  if (guards == 0) return;
  guards = 0; // reporting may allocate
  std::fputs("the heap is used under a no_heap::guard\n", stderr);
  std::abort();
}

} // namespace

namespace no_heap {

std::size_t allocations() noexcept { return count; }
guard::guard() noexcept { ++guards; }
guard::~guard() { --guards; }

} // namespace no_heap

// The linker sends the program's calls of malloc here (--wrap) and __real_malloc to the C library.
extern "C" {
void* __real_malloc(std::size_t);
void* __real_calloc(std::size_t, std::size_t);
void* __real_realloc(void*, std::size_t);
void* __real_aligned_alloc(std::size_t, std::size_t);
int __real_posix_memalign(void**, std::size_t, std::size_t);

void* __wrap_malloc(std::size_t size) {
  note();
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t number, std::size_t size) {
  note();
  return __real_calloc(number, size);
}
void* __wrap_realloc(void* old, std::size_t size) {
  note();
  return __real_realloc(old, size);
}
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  note();
  return __real_aligned_alloc(alignment, size);
}
int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  note();
  return __real_posix_memalign(memory, alignment, size);
}
}

// The array and nothrow forms in the standard library call these four.
void* operator new(std::size_t size) {
  void* memory = std::malloc(size != 0 ? size : 1);
  if (memory == nullptr) std::abort();
  return memory;
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (memory == nullptr) std::abort();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
