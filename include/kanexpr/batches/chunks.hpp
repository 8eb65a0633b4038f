#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

/// The division of work on many systems into chunks that threads can share.
namespace kanexpr::batches {

/// Runs everything on the calling thread.
struct sequential {};

/// The division of systems into chunks; it does not depend on the executor.
struct chunks {
  static constexpr int most = 256;
  int count = 0;
  Eigen::Index length = 0; ///< length of each chunk except the last

  /// Divides `systems` into chunks of at least `least` systems each, except the last. Each chunk consists of
  /// whole cache lines and whole batches of `width`.
  static constexpr chunks of(Eigen::Index systems, Eigen::Index least, Eigen::Index width) {
    if (systems <= 0) return {};
    const Eigen::Index unit = (std::max)(Eigen::Index{16}, width); // both are powers of two
    const Eigen::Index wanted = (std::max)(least, (systems + most - 1) / most);
    const Eigen::Index length = (wanted + unit - 1) / unit * unit;
    return {static_cast<int>((systems + length - 1) / length), length};
  }
};

/// The indices of all chunks, for algorithms that take a range.
inline constexpr auto chunk_numbers = [] {
  std::array<std::int16_t, chunks::most> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int16_t>(i);
  return all;
}();

/// Calls work(i) for i = 0 … count − 1: on this thread, through a callable, or through an execution policy of
/// the standard library, whose header the caller must include.
template <class Executor, class Work>
void run_chunks([[maybe_unused]] Executor&& by, int count, const Work& work) {
  if constexpr (std::same_as<std::remove_cvref_t<Executor>, sequential>)
    for (int i = 0; i < count; ++i) work(i);
  else if constexpr (std::invocable<Executor&, int, const Work&>)
    by(count, work);
  else
    std::for_each(std::forward<Executor>(by), chunk_numbers.data(), chunk_numbers.data() + count, work);
}

} // namespace kanexpr::batches
