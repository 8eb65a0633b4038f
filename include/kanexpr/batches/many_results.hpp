#pragma once

#include <kanexpr/base/status.hpp>
#include <kanexpr/batches/chunks.hpp>
#include <kanexpr/batches/evaluation.hpp>
#include <kanexpr/batches/system_statuses.hpp>
#include <kanexpr/compiled/status.hpp>

#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <utility>

namespace kanexpr {

/// The results of a compiled function for many systems, with a status for each:
///
///     many_results rates(eom::udot, 1000);
///     rates.evaluate(x, p, r);             // many<eom::state> x(1000); one p for all, or one for each; …
///     rates(2);                            // the third entry of all systems, as a row
///     if (!rates.status_of(17)) …
///
/// Memory is allocated on construction; an evaluation neither allocates memory nor throws. Systems are
/// evaluated in batches; a batch in which a system fails is evaluated again, system by system. Therefore the
/// other systems keep their results, the results of a failed system are NaN, and no result depends on
/// adjacent systems or on the threads.
template <class Function, class Number = double, std::size_t lanes = batches::default_lanes<Number>>
class many_results {
  using described = batches::evaluated<Function>;
  using matrices = typename described::template matrices<Number>;
  using pack = typename batch<lanes, Number>::number;
  static constexpr Eigen::Index width = static_cast<Eigen::Index>(lanes);

public:
  explicit many_results(Eigen::Index systems) : many_results(Function{}, systems) {}
  many_results(const Function&, Eigen::Index systems)
      : results_(make_results(systems, std::make_index_sequence<described::results>{})), statuses_(systems) {}

  Eigen::Index size() const { return statuses_.size(); }

  /// Evaluates the function for all systems: evaluate(x), (x, p), (x, p, r) or (x, p, r, a), preceded by the
  /// time if the function needs it. The states are `many`; parameters, inputs and rates are `many` or one
  /// vector for all systems. Returns the status of the first system that failed.
  ///
  /// An optional first argument distributes the work among threads: an execution policy of the standard
  /// library, such as `std::execution::par`, or a callable `by(count, chunk)` that calls chunk(i) for i = 0 …
  /// count − 1, in any order, on any threads, and returns when all calls have returned.
  template <class First, class... More>
  status evaluate(First&& first, const More&... more) {
    constexpr bool are_many = !batches::single<std::remove_cvref_t<First>>;
    constexpr bool have_one_precision = batches::is_of_numbers<std::remove_cvref_t<First>, Number> &&
                                        (batches::is_of_numbers<More, Number> && ...);
    static_assert(are_many, "evaluate takes `many` states; for one state, call the function itself");
    static_assert(have_one_precision,
                  "the precision of the `many` arguments differs from that of the results");
    if constexpr (!are_many || !have_one_precision)
      return {};
    else if constexpr (is_argument<std::remove_cvref_t<First>>)
      return evaluate_by(batches::sequential{}, first, more...);
    else
      return evaluate_by(std::forward<First>(first), more...);
  }

  /// Returns the result with index `which`; its entry (i, j) in all systems is a row.
  template <std::size_t which = 0>
  const auto& result() const {
    return std::get<which>(results_);
  }
  /// Returns an entry of the first result in all systems.
  auto operator()(int i = 0, int j = 0) const { return result()(i, j); }

  /// Returns the status of a system, with the cause if it has no result.
  const status& status_of(Eigen::Index system) const { return statuses_.of(system); }
  /// Returns the number of systems without a result.
  Eigen::Index failures() const { return statuses_.failures(); }

private:
  template <class Argument>
  static constexpr bool is_argument = batches::is_many<Argument> || std::is_arithmetic_v<Argument>;

  template <std::size_t... place>
  static matrices make_results(Eigen::Index systems, std::index_sequence<place...>) {
    return matrices(std::tuple_element_t<place, matrices>(systems)...);
  }

  template <class Executor, class... Arguments>
  status evaluate_by(Executor&& by, const Arguments&... arguments) {
    if (!(... && batches::has_size(arguments, size())))
      return refuse(status("the arguments and the results have different numbers of systems"));
    statuses_.run(
        std::forward<Executor>(by), chunk_of_systems, width,
        [&](Eigen::Index begin, Eigen::Index end) { return evaluate_range(begin, end, arguments...); },
        [&](Eigen::Index begin, Eigen::Index end) { set_to_nan(begin, end); });
    return statuses_.first();
  }

  status refuse(const status& why) {
    set_to_nan(0, size());
    return statuses_.refuse(why);
  }

  /// About ten microseconds of work.
  static constexpr Eigen::Index chunk_of_systems = [] {
    const auto& c = Function::cost();
    return 40000 / (c.multiplications + c.additions + 10 * c.divisions + 20 * c.trigonometric + 20);
  }();

  using places = std::array<batches::strided_output<Number>, described::results>;

  template <std::size_t... index>
  places places_at(Eigen::Index system, std::index_sequence<index...>) {
    return {batches::strided_output<Number>{std::get<index>(results_).data() + system,
                                            std::get<index>(results_).stride()}...};
  }
  places places_at(Eigen::Index system) {
    return places_at(system, std::make_index_sequence<described::results>{});
  }

  /// Evaluates the systems [begin, end); returns how many of them failed.
  template <class... Arguments>
  Eigen::Index evaluate_range(Eigen::Index begin, Eigen::Index end, const Arguments&... arguments) noexcept {
    Eigen::Index failed = 0;
    for (Eigen::Index first = begin; first < end; first += width) {
      const Eigen::Index count = (std::min)(width, end - first);
      const status all =
          count == width
              ? batches::evaluate_pack<Function, pack>(places_at(first).data(),
                                                       batches::argument_from_rows<pack>(arguments, first)...)
              : evaluate_copies(first, count, first + count - 1, arguments...);
      if (all) continue;
      for (Eigen::Index system = first; system < first + count; ++system)
        failed += !evaluate_one(system, arguments...);
    }
    return failed;
  }

  /// Evaluates `count` systems from `first` on; surplus lanes repeat the system `last`.
  template <class... Arguments>
  status evaluate_copies(Eigen::Index first, Eigen::Index count, Eigen::Index last,
                         const Arguments&... arguments) noexcept {
    return evaluate_copied(first, count, batches::copy_argument<pack>(arguments, first, last)...);
  }
  template <class... Copies>
  status evaluate_copied(Eigen::Index first, Eigen::Index count, const Copies&... copies) noexcept {
    scratch of_all;
    const status found =
        batches::evaluate_pack<Function, pack>(of_all.at().data(), batches::argument_from_copies(copies)...);
    if (found) of_all.move_to(places_at(first), count);
    return found;
  }

  /// Evaluates one system in all lanes.
  template <class... Arguments>
  bool evaluate_one(Eigen::Index system, const Arguments&... arguments) noexcept {
    const status found = evaluate_copies(system, 1, system, arguments...);
    if (found) return true;
    statuses_.set(system, cause(found, system, arguments...));
    set_to_nan(system, system + 1);
    return false;
  }

  template <class First, class... More>
  static status cause(const status& found, Eigen::Index system, const First& first, const More&... more) {
    if constexpr (std::is_arithmetic_v<First>)
      return batches::cause_of<Function>(found, batches::of_system(more, system)...);
    else
      return batches::cause_of<Function>(found, batches::of_system(first, system),
                                         batches::of_system(more, system)...);
  }

  static constexpr std::array<int, described::results> entries =
      []<std::size_t... place>(std::index_sequence<place...>) {
        return std::array{std::tuple_element_t<place, matrices>::entries...};
      }(std::make_index_sequence<described::results>{});
  static constexpr std::size_t all_entries = [] {
    std::size_t sum = 0;
    for (const int each : entries) sum += static_cast<std::size_t>(each);
    return sum;
  }();

  /// Storage for the results of one batch.
  struct scratch {
    alignas(pack) Number numbers[all_entries > 0 ? all_entries : 1][lanes];

    places at() {
      places found{};
      std::size_t begin = 0;
      for (std::size_t k = 0; k < entries.size(); ++k) {
        found[k] = {numbers[begin], width};
        begin += static_cast<std::size_t>(entries[k]);
      }
      return found;
    }
    void move_to(const places& to, Eigen::Index systems) const {
      const Number(*entry)[lanes] = numbers;
      for (std::size_t k = 0; k < entries.size(); ++k)
        for (int i = 0; i < entries[k]; ++i, ++entry)
          std::copy_n(*entry, systems, to[k].first + i * to[k].stride);
    }
  };

  void set_to_nan(Eigen::Index begin, Eigen::Index end) {
    std::apply([&](auto&... each) { (each.set_to_nan(begin, end), ...); }, results_);
  }

  matrices results_;
  batches::system_statuses statuses_;
};

} // namespace kanexpr
