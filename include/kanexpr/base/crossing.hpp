#pragma once

namespace kanexpr {

/// How a watched expression passes zero.
enum class crossing { falling = -1, either = 0, rising = 1 };

/// Whether the motion goes on after an event.
enum class after_event { go_on, stop };

} // namespace kanexpr
