#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace playground {

/// A sentence of the library without the remedies that a text cannot express, such as `used_elsewhere`. A
/// redundant constraint is left out here instead of being listed.
inline std::string in_words_of_texts(const std::string& sentence) {
  for (const std::string_view remedy : {"; if this is intended", ", if this is intended"})
    if (const std::size_t at = sentence.find(remedy); at != sentence.npos) return sentence.substr(0, at);
  if (const std::size_t at = sentence.find("; add redundant<"); at != sentence.npos)
    return sentence.substr(0, at) + (sentence.ends_with("them") ? "; leave them out" : "; leave it out");
  return sentence;
}

} // namespace playground
