#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/fixed_tape.hpp>
#include <kanexpr/lower/scalar_math.hpp>
#include <kanexpr/lower/side_by_side.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>

#include <type_traits>
#include <utility>

namespace kanexpr::lower {

/// Whether one register of the target holds as many numbers as a step on vectors has.
template <class Number>
inline constexpr bool has_vectors =
#if defined(__AVX__)
    std::is_same_v<Number, double> || std::is_same_v<Number, float>;
#elif defined(__SSE2__) || defined(__ARM_NEON)
    std::is_same_v<Number, float>;
#else
    false;
#endif

/// The number of actions in a piece of a list that is longer than five pieces; it may be specialized.
template <class Code>
inline constexpr int actions_per_piece = 1500;

/// What is done one after another where steps on vectors take part in a tape. Each action computes one value
/// from one or two of those before: a number, which is the first lane of a vector, or a vector.
///
/// A long list is cut into pieces, each of which becomes one function. Numbers that are known at the start,
/// results, and values that several pieces use have a place in memory.
template <class Code>
class vector_plan {
  static constexpr const auto& tape = Code::tape;
  static constexpr int none = -1, piece_length = actions_per_piece<Code>;

public:
  static constexpr int known = tape.first_step() + tape.sizes.first_angle + 2 * tape.sizes.angles;
  /// Actions besides the operations on numbers: taking two numbers as half a vector, joining two halves,
  /// taking a number from the first lane of a vector (and so on), a sine with its cosine, and steps on
  /// vectors.
  static constexpr int half = -1, whole = -2, first_lane = -3, sine_and_cosine = first_lane - lanes,
                       first_step = sine_and_cosine - 1;
  /// A step on vectors is its operation, whether each operand is a vector, and which lanes change the sign of
  /// an operand.
  static constexpr int signs = 1 << lanes;
  static constexpr int step_on_vectors(operation op, bool first_is_vector, bool second_is_vector, int sign) {
    return first_step -
           (((static_cast<int>(op) * 2 + first_is_vector) * 2 + second_is_vector) * signs + sign);
  }
  static constexpr bool is_vector(int action) {
    return action <= sine_and_cosine || action == half || action == whole;
  }

  static constexpr std::size_t room = 3 * static_cast<std::size_t>(tape.sizes.steps) + 1,
                               most_pieces = room / piece_length + 2;
  int what[room]{};
  int a[room]{}, b[room]{}; ///< among the values of a piece: its inputs, then its actions
  int place[room]{};        ///< in memory, of what an action computes, or -1
  int inputs[2 * room]{};   ///< the places of the inputs of all pieces
  bool is_vector_input[2 * room]{};
  int result[static_cast<std::size_t>(tape.sizes.results)]{}; ///< values, or places if there are pieces
  int first[most_pieces]{}, first_input[most_pieces]{};
  int count = 0, pieces = 0, places = known;

  constexpr vector_plan() {
    list_actions();
    const int length = count > 5 * piece_length ? piece_length : count;
    for (int next = 0; next < count; next += length) first[pieces++] = next;
    first[pieces] = count;
    if (pieces > 1) place_values();
  }

private:
  constexpr int add(int action, int one, int other) {
    what[count] = action;
    a[count] = one, b[count] = other;
    place[count] = none;
    return known + count++;
  }

  /// Lists the actions; values are counted from the numbers that are known.
  constexpr void list_actions() {
    const side_by_side found(tape_view(tape), view<int>(tape.columns, tape.sizes.columns), known);
    sequence<int> values(tape.slot_count(), none), vectors(found.packs().size(), none);
    sequence<char> are_results(tape.slot_count(), 0);
    int *const value_of = values.begin(), *const vector_of = vectors.begin();
    char* const is_result = are_results.begin();
    for (int i = 0; i < known; ++i) value_of[i] = i;
    for (int i = 0; i < tape.sizes.results; ++i) is_result[tape.results[i]] = 1;
    const auto number = [&](int slot) {
      if (value_of[slot] == none) {
        const int lane = found.lane_of(slot);
        value_of[slot] = add(first_lane - lane % lanes, vector_of[lane / lanes], 0);
      }
      return value_of[slot];
    };
    const auto vector = [&](const pack& of, bool& is_vector) {
      pack operands = of;
      const int index = found.pack_of(operands);
      if (index != none) return vector_of[index];
      bool same = true;
      for (int each : operands.slot) same = same && each == operands.slot[0];
      for (int& each : operands.slot) each = number(each);
      is_vector = !same;
      if (same) return operands.slot[0];
      const int lower = add(half, operands.slot[0], operands.slot[1]);
      const int upper = add(half, operands.slot[2], operands.slot[3]);
      return add(whole, lower, upper);
    };
    for (int slot : found.order_of_slots()) {
      const instruction& s = found.step_of(slot);
      const bool is_binary = symbolic::is_binary(s.op);
      const int lane = found.lane_of(slot);
      if (lane == none && !s.paired) {
        const int one = value_of[s.a] == none ? number(s.a) : value_of[s.a];
        const int other = !is_binary ? 0 : value_of[s.b] == none ? number(s.b) : value_of[s.b];
        value_of[slot] = add(static_cast<int>(s.op), one, other);
      } else if (lane != none) {
        const pack& p = found.packs()[lane / lanes];
        bool first_is_vector = true, second_is_vector = true;
        const int one = vector(found.operands_of(p, false), first_is_vector);
        const int other = is_binary ? vector(found.operands_of(p, true), second_is_vector) : 0;
        const operation op = s.op == operation::subtract ? operation::add : s.op;
        vector_of[lane / lanes] =
            add(step_on_vectors(op, first_is_vector, second_is_vector, p.signs), one, other);
        for (int each : p.slot)
          if (is_result[each] != 0) number(each);
      } else {
        const int both = add(sine_and_cosine, number(s.a), 0);
        for (int i = 0; i < 2; ++i) value_of[slot + i] = add(first_lane - i, both, 0);
      }
    }
    for (int i = 0; i < tape.sizes.results; ++i) result[i] = number(tape.results[i]);
  }

  /// Gives places to the values that several pieces use, and counts the values of each piece from its inputs.
  constexpr void place_values() {
    sequence<int> place_in_memory(known + count, none), input_of(known + count, none);
    int *const place_of = place_in_memory.begin(), *const input = input_of.begin();
    for (int i = 0; i < known; ++i) place_of[i] = i;
    for (int& each : result) {
      if (place_of[each] == none) place_of[each] = places++;
      each = place_of[each];
    }
    int next = 0;
    const auto add_input = [&](int value) {
      const bool of_vector = value >= known && is_vector(what[value - known]);
      if (place_of[value] == none) {
        place_of[value] = places;
        places += of_vector ? lanes : 1;
      }
      inputs[next] = place_of[value];
      is_vector_input[next] = of_vector;
      input[value] = next++;
    };
    for (int p = 0; p < pieces; ++p) {
      const int start = first_input[p] = next, own = known + first[p];
      for (int i = first[p]; i < first[p + 1]; ++i) {
        if (a[i] < own && input[a[i]] < start) add_input(a[i]);
        if (b[i] < own && input[b[i]] < start) add_input(b[i]);
      }
      for (int i = first[p]; i < first[p + 1]; ++i) {
        a[i] = a[i] >= own ? next - start + a[i] - own : input[a[i]] - start;
        b[i] = b[i] >= own ? next - start + b[i] - own : input[b[i]] - start;
      }
    }
    first_input[pieces] = next;
    for (int i = 0; i < count; ++i) place[i] = place_of[known + i];
  }
};

template <class Code>
inline constexpr vector_plan<Code> vector_plan_of{};

/// Whether an evaluation uses steps on vectors; it does if they replace some of the work.
template <class Code, class Number>
consteval bool uses_vectors() {
  if constexpr (Code::tape.sizes.columns == 0 || !has_vectors<Number>)
    return false;
  else
    return 20 * vector_plan_of<Code>.count < 19 * Code::tape.sizes.steps;
}

/// Straight-line evaluation of a tape with steps on vectors, with the same bits as one number after another;
/// if the compiler fuses multiply-adds, it may fuse other ones.
template <class Code, class Number>
class steps_on_vectors {
  static constexpr const vector_plan<Code>& plan = vector_plan_of<Code>;
  typedef Number vector __attribute__((vector_size(lanes * sizeof(Number))));
  typedef Number vector_in_memory
      __attribute__((vector_size(lanes * sizeof(Number)), aligned(alignof(Number)), may_alias));

public:
  static constexpr bool in_pieces = plan.pieces > 1;
  /// Where the results are in the array that `run` fills, and the length of this array.
  static consteval int place_of(int result) { return in_pieces ? plan.result[result] : result; }
  static constexpr int places = in_pieces ? plan.places : Code::tape.sizes.results;

  /// Evaluates the steps that follow the numbers `known`.
  [[gnu::always_inline]] static void run(const Number* known, Number* memory) noexcept {
    if constexpr (in_pieces)
      run_pieces(known, memory, up_to<plan.known>{}, up_to<plan.pieces>{});
    else
      run_at_once(known, memory, up_to<plan.known>{}, up_to<plan.count>{}, up_to<Code::tape.sizes.results>{});
  }

private:
  template <int count>
  using up_to = std::make_integer_sequence<int, count>;
  enum class keeping : char { nothing, number, whole_vector };

  template <int... number, int... index, int... result>
  [[gnu::always_inline]] static void
  run_at_once(const Number* known, Number* to, std::integer_sequence<int, number...>,
              std::integer_sequence<int, index...>, std::integer_sequence<int, result...>) noexcept {
    const vector value[]{vector{known[number]}..., take<plan.what[index], keeping::nothing>(
                                                       value[a(index)], value[b(index)], nullptr)...};
    const int order[]{0, (to[result] = value[plan.result[result]][0], 0)...};
    static_cast<void>(order);
  }

  template <int... number, int... piece>
  [[gnu::always_inline]] static void run_pieces(const Number* known, Number* memory,
                                                std::integer_sequence<int, number...>,
                                                std::integer_sequence<int, piece...>) noexcept {
    const int order[]{(memory[number] = known[number], 0)...};
    static_cast<void>(order);
    (one_piece<piece>(memory), ...);
  }
  template <int piece>
  [[gnu::noinline]] static void one_piece(Number* memory) noexcept {
    steps<plan.first_input[piece], plan.first[piece]>(
        memory, up_to<plan.first_input[piece + 1] - plan.first_input[piece]>{},
        up_to<plan.first[piece + 1] - plan.first[piece]>{});
  }
  template <int first_input, int first, int... input, int... index>
  [[gnu::always_inline]] static void steps(Number* memory, std::integer_sequence<int, input...>,
                                           std::integer_sequence<int, index...>) noexcept {
    [[maybe_unused]] const vector value[]{
        input_from<plan.is_vector_input[first_input + input]>(memory + input_place(first_input + input))...,
        take<plan.what[first + index], kept(first + index)>(value[a(first + index)], value[b(first + index)],
                                                            memory + place(first + index))...};
  }

  // consteval, because clang++ would otherwise load an index from the plan
  static consteval int a(int action) { return plan.a[action]; }
  static consteval int b(int action) { return plan.b[action]; }
  static consteval int place(int action) { return plan.place[action] < 0 ? 0 : plan.place[action]; }
  static consteval int input_place(int input) { return plan.inputs[input]; }
  static consteval keeping kept(int action) {
    return plan.place[action] < 0              ? keeping::nothing
           : plan.is_vector(plan.what[action]) ? keeping::whole_vector
                                               : keeping::number;
  }

  template <bool is_vector>
  [[gnu::always_inline]] static vector input_from(const Number* memory) noexcept {
    if constexpr (is_vector)
      return *reinterpret_cast<const vector_in_memory*>(memory);
    else
      return vector{*memory};
  }

  template <int what, keeping keeps>
  [[gnu::always_inline]] static vector take(const vector a, const vector b,
                                            [[maybe_unused]] Number* memory) noexcept {
    const vector value = computed<what>(a, b);
    if constexpr (keeps == keeping::number)
      *memory = value[0];
    else if constexpr (keeps == keeping::whole_vector)
      *reinterpret_cast<vector_in_memory*>(memory) = value;
    return value;
  }

  template <int what>
  [[gnu::always_inline]] static vector computed(const vector a, [[maybe_unused]] const vector b) noexcept {
    if constexpr (what >= 0) {
      return vector{apply<static_cast<operation>(what), Number>(a[0], b[0])};
    } else if constexpr (what == plan.half) {
      return vector{a[0], b[0]};
    } else if constexpr (what == plan.whole) {
      return vector{a[0], a[1], b[0], b[1]};
    } else if constexpr (what == plan.sine_and_cosine) {
      Number sine, cosine;
      scalar_math<Number>::sincos(a[0], sine, cosine);
      return vector{sine, cosine};
    } else if constexpr (what > plan.sine_and_cosine) {
      return vector{a[plan.first_lane - what]};
    } else {
      constexpr int step = plan.first_step - what, signs = step % plan.signs, kind = step / plan.signs;
      return combined<static_cast<operation>(kind / 4), signs>(in_all_lanes < (kind & 2) == 0 > (a),
                                                               in_all_lanes < (kind & 1) == 0 > (b));
    }
  }

  template <bool is_number>
  [[gnu::always_inline]] static vector in_all_lanes(const vector of) noexcept {
    if constexpr (is_number)
      return of[0] - vector{}; // minus zero, so that zeros keep their sign
    else
      return of;
  }

  /// The product with a sign is exact.
  template <operation op, int signs>
  [[gnu::always_inline]] static vector combined(const vector a, [[maybe_unused]] const vector b) noexcept {
#if defined(__clang__) && !defined(KANEXPR_NO_FUSING)
#pragma clang fp contract(fast)
#endif
    [[maybe_unused]] constexpr vector sign = signs_of<signs>(std::make_integer_sequence<int, lanes>{});
    if constexpr (op == operation::negate)
      return -a;
    else if constexpr (op == operation::divide)
      return a / b;
    else if constexpr (op == operation::multiply && signs == 0)
      return a * b;
    else if constexpr (op == operation::multiply)
      return sign * a * b;
    else if constexpr (signs == 0)
      return a + b;
    else if constexpr (signs == plan.signs - 1)
      return a - b;
    else
      return a + sign * b;
  }
  template <int signs, int... lane>
  static consteval vector signs_of(std::integer_sequence<int, lane...>) {
    return vector{(signs >> lane & 1) != 0 ? Number(-1) : Number(1)...};
  }
};

} // namespace kanexpr::lower
