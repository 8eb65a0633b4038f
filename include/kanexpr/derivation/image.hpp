#pragma once

#include <kanexpr/describe/record.hpp>
#include <kanexpr/symbolic/graph/external.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <cstdint>

namespace kanexpr::derivation {

/// A stored derivation, as plain arrays that can outlive constant evaluation: the graph node by node, and
/// everything else known at that stage as a sequence of integers.
///
/// It has room for any model that a compiler can derive in reasonable time; entries beyond the counts are
/// unused. It must be used only in constant evaluation, because any other reference would put it into the
/// program.
struct image {
  static constexpr int most_nodes = 1 << 17;
  static constexpr int most_integers = 1 << 18;
  static constexpr int most_numbers = 1 << 14;
  static constexpr int most_entities = 1 << 12;
  static constexpr int most_externals = 1 << 8;

  int nodes = 0;
  symbolic::operation op[most_nodes]{};
  int a[most_nodes]{};
  int b[most_nodes]{};

  int numbers = 0;
  std::int64_t numerators[most_numbers]{};
  std::int64_t denominators[most_numbers]{};
  double reals[most_numbers]{};

  int integers = 0;
  int integer[most_integers]{};

  int frames = 0;
  const describe::frame_record* frame[most_entities]{};
  int points = 0;
  const describe::point_record* point[most_entities]{};

  int externals = 0;
  const symbolic::external_function* external[most_externals]{};

  /// Whether a part was omitted for lack of room.
  bool is_full = false;
};

} // namespace kanexpr::derivation
