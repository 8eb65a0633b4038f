// Start-up of a Cortex-M with a floating-point unit: the vectors, and what has to be done before a program.
#include <cstdint>

extern "C" {

// From the linker script.
extern std::uint32_t data_image[], data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];

[[noreturn]] void run(); // the program
[[noreturn]] void fault();

[[noreturn]] void reset() {
  auto& coprocessors = *reinterpret_cast<volatile std::uint32_t*>(0xE000ED88);
  coprocessors = coprocessors | 0xFU << 20U; // the floating-point unit is one
  __asm volatile("dsb\n isb");
  const std::uint32_t* from = data_image;
  for (std::uint32_t* to = data_begin; to < data_end;) *to++ = *from++;
  for (std::uint32_t* to = bss_begin; to < bss_end;) *to++ = 0;
  run();
}
}

namespace {

struct vector_table {
  const void* stack;
  void (*handlers[15])(); // reset, the faults, and the exceptions of the system, which nothing here asks for
};

[[gnu::section(".vectors"), gnu::used]] const vector_table vectors{stack_top,
                                                                   {reset, fault, fault, fault, fault, fault,
                                                                    fault, fault, fault, fault, fault, fault,
                                                                    fault, fault, fault}};

} // namespace
