#pragma once

#include "playground/text/tree.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace playground {

/// A line of a model: its word and what fills the slots of its pattern, in order. An omitted optional slot is
/// an empty entry.
struct line {
  struct slot {
    std::string name{};          ///< of slots for names
    std::vector<tree> written{}; ///< of slots for expressions and lists
    bool is_given = false;
  };

  int number = 0; ///< from 1
  std::string word{};
  std::vector<slot> slots{};

  const std::string& name(std::size_t i) const { return slots[i].name; }
  const tree& expression(std::size_t i) const { return slots[i].written[0]; }
  const std::vector<tree>& list(std::size_t i) const { return slots[i].written; }
  bool has(std::size_t i) const { return slots[i].is_given; }
};

/// A mistake and the line in which it was made; 0 if it concerns the whole model.
struct mistake {
  int line = 0;
  std::string sentence{};
};

} // namespace playground
