// Calls a measured function at each of its points and writes a line for each: executed instructions, bytes of
// stack, and the bits of its results.
#include "../layout.hpp"
#include "semihosting.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

extern "C" {
extern std::uint32_t stack_limit[]; // from the linker script

[[gnu::noipa]] void nothing(const scalar*, scalar*) {}

[[noreturn]] void fault() {
  semihosting::write("a fault of the processor\n");
  semihosting::end(false);
}
}

namespace {

using function = void(const scalar*, scalar*);

// A timer of the board, which counts down. Its ticks are 40 ns; the emulator takes 256 ns for each
// instruction.
class counter {
public:
  counter() {
    reload() = ~std::uint32_t{0};
    control() = 1; // count, without interrupts
  }
  std::uint32_t operator()() const { return value(); }
  static std::uint32_t instructions(std::uint32_t before, std::uint32_t after) {
    return static_cast<std::uint32_t>((std::uint64_t{before - after} * 40 + 128) / 256);
  }

private:
  using word = volatile std::uint32_t;
  static word& at(std::uint32_t offset) { return *reinterpret_cast<word*>(0x40000000 + offset); }
  static word& control() { return at(0); }
  static word& value() { return at(4); }
  static word& reload() { return at(8); }
};

[[gnu::noipa]] std::uint32_t instructions_of(function* f, const counter& now, const scalar* given,
                                             scalar* found) {
  const std::uint32_t before = now();
  f(given, found);
  return counter::instructions(before, now());
}

[[gnu::noipa]] std::uint32_t stack_of(function* f, const scalar* given, scalar* found) {
  constexpr std::uint32_t paint = 0xA5C3965A;
  std::uint32_t* here = nullptr;
  __asm volatile("mov %0, sp" : "=r"(here));
  volatile std::uint32_t* lowest = stack_limit;
  for (volatile std::uint32_t* at = lowest; at < here; ++at) *at = paint;
  f(given, found);
  while (lowest < here && *lowest == paint) ++lowest;
  return static_cast<std::uint32_t>(here - lowest) * sizeof paint;
}

void write_number(std::uint32_t number) {
  char text[11]{};
  char* begin = text + 10;
  do *--begin = static_cast<char>('0' + number % 10);
  while ((number /= 10) != 0);
  semihosting::write(begin);
}

void write_bits(scalar value) {
  using bits = std::conditional_t<sizeof value == 4, std::uint32_t, std::uint64_t>;
  char text[2 * sizeof value + 2]{' '};
  bits left = std::bit_cast<bits>(value);
  for (std::size_t i = 2 * sizeof value; i > 0; --i, left >>= 4U) text[i] = "0123456789abcdef"[left & 15U];
  semihosting::write(text);
}

scalar found[512];

} // namespace

extern "C" void run() {
  const counter now;
  for (std::uint32_t point = 0; point < calls.point_count; ++point) {
    const scalar* given = calls.points + point * calls.given_count;
    const std::uint32_t stack = stack_of(measured, given, found);
    const std::uint32_t beside = instructions_of(nothing, now, given, found);
    write_number(instructions_of(measured, now, given, found) - beside);
    semihosting::write(" ");
    write_number(stack);
    for (std::uint32_t i = 0; i < calls.found_count; ++i) write_bits(found[i]);
    semihosting::write("\n");
  }
  semihosting::end(true);
}
