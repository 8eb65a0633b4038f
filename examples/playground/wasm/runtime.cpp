/// What the libraries expect of a C++ runtime and Debian's for WebAssembly does not define.
#include <boost/throw_exception.hpp>

#include <cstdint>
#include <cstdlib>

namespace boost {

// Without exceptions, Boost calls these functions; the engine never lets it come to that.
void throw_exception(const std::exception&) { std::abort(); }
void throw_exception(const std::exception&, const source_location&) { std::abort(); }

} // namespace boost

extern "C" {

// Debian compiles its arithmetic of 128 bits with protection of the stack.
std::uintptr_t __stack_chk_guard = 0x5afe57ac;
void __stack_chk_fail() { std::abort(); }
}
