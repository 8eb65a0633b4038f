#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#if defined(__SSE2__) && !defined(__clang__)
#include <immintrin.h>
#endif

namespace kanexpr::numeric {

/// Returns the square roots of all lanes of one of the compiler's vectors, each rounded like the square root
/// of a scalar. Without explicit vector operations, compilers compute them one by one with a branch for
/// `errno`. Vectors wider than those of the processor are halved.
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
#if defined(__AVX512F__) // masked, because g++ 12 warns about the value that others would leave
  if constexpr (std::is_same_v<number, double> && sizeof(Number) == 64)
    return Number(_mm512_maskz_sqrt_pd(__mmask8(0xFF), __m512d(x)));
  if constexpr (std::is_same_v<number, float> && sizeof(Number) == 64)
    return Number(_mm512_maskz_sqrt_ps(__mmask16(0xFFFF), __m512(x)));
#endif
  constexpr std::size_t count = sizeof(Number) / sizeof(number);
  if constexpr (count % 2 == 0 && sizeof(Number) > 16)
    return [&]<std::size_t... low>(std::index_sequence<low...>) __attribute__((always_inline)) {
      const auto below = square_roots(__builtin_shufflevector(x, x, low...));
      const auto above = square_roots(__builtin_shufflevector(x, x, count / 2 + low...));
      return __builtin_shufflevector(below, above, low..., count / 2 + low...);
    }(std::make_index_sequence<count / 2>{});
  Number roots{};
  for (std::size_t i = 0; i < count; ++i) roots[i] = std::sqrt(x[i]);
  return roots;
#endif
}

} // namespace kanexpr::numeric
