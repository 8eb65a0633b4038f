#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#if defined(__SSE2__) && !defined(__clang__)
#include <immintrin.h>
#endif

namespace kanexpr::numeric {

/// Returns the square roots of all lanes of one of the compiler's vectors, each rounded like the square root
/// of a scalar. Without explicit vector operations, compilers compute them one by one with a branch for
/// `errno`.
template <class Number>
[[gnu::always_inline]] inline Number square_roots(const Number& x) noexcept {
#if defined(__clang__)
  return __builtin_elementwise_sqrt(x);
#else
  using number = std::remove_cvref_t<decltype(x[0])>;
#if defined(__SSE2__)
  if constexpr (std::is_same_v<number, double> && sizeof(Number) == 16)
    return Number(_mm_sqrt_pd(__m128d(x)));
  if constexpr (std::is_same_v<number, float> && sizeof(Number) == 16) return Number(_mm_sqrt_ps(__m128(x)));
#endif
#if defined(__AVX__)
  if constexpr (std::is_same_v<number, double> && sizeof(Number) == 32)
    return Number(_mm256_sqrt_pd(__m256d(x)));
  if constexpr (std::is_same_v<number, float> && sizeof(Number) == 32)
    return Number(_mm256_sqrt_ps(__m256(x)));
#endif
  Number roots{};
  for (std::size_t i = 0; i < sizeof(Number) / sizeof(number); ++i) roots[i] = std::sqrt(x[i]);
  return roots;
#endif
}

} // namespace kanexpr::numeric
