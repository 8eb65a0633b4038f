#pragma once

namespace docs {

/// Whether all words of a list that the documentation shows without a system are complete types.
template <class... Words>
constexpr bool complete = ((sizeof(Words) > 0) && ...);

} // namespace docs
