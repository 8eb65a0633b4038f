#pragma once

#include <kanexpr/ensemble/random_number.hpp>
#include <kanexpr/ensemble/sum_of_bytes.hpp>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace kanexpr::ensembles {

KANEXPR_ENSEMBLES std::uint64_t sum_of(std::string_view content) {
  std::uint64_t sum = content.size();
  while (!content.empty()) {
    std::uint64_t word = 0;
    const std::size_t count = (std::min)(content.size(), sizeof word);
    std::memcpy(&word, content.data(), count);
    sum = mixed((sum << 1 | sum >> 63) ^ mixed(word + 0x9e3779b97f4a7c15));
    content.remove_prefix(count);
  }
  return sum;
}

} // namespace kanexpr::ensembles
