#pragma once

namespace kanexpr {

/// The direction in which a watched expression crosses zero.
enum class crossing { falling = -1, either = 0, rising = 1 };

/// Whether the motion continues after an event.
enum class after_event { go_on, stop };

} // namespace kanexpr
