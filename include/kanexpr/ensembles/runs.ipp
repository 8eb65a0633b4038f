#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/ensembles/lerp.hpp>
#include <kanexpr/ensembles/random_stream.hpp>
#include <kanexpr/ensembles/runs.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace kanexpr {

namespace ensembles {

inline constexpr std::size_t max_runs = std::size_t{1} << 53; // a column holds the run numbers

inline std::string mistake_in(const std::vector<varied_name>& what) {
  for (std::size_t i = 0; i < what.size(); ++i) {
    if (what[i].name().empty()) return "a varied quantity has no name";
    for (std::size_t k = 0; k < i; ++k)
      if (what[k].name() == what[i].name()) return what[i].name() + " is varied twice";
  }
  return {};
}

/// Draws each value from the whole distribution or, if `stratified`, from an interval that no other run uses.
inline runs drawn_runs(std::size_t count, std::vector<drawn> what, std::uint64_t seed, bool stratified) {
  const std::string name = stratified ? "latin_hypercube" : "random_runs";
  std::string identity = name + '(' + std::to_string(count) + ", {";
  std::vector<varied_name> names;
  std::vector<random_stream> numbers;
  std::vector<permutation> orders;
  for (const drawn& each : what) {
    if (!each.from.mistake().empty()) return runs::mistaken(each.from.mistake());
    identity += (names.empty() ? "{" : ", {") + each.what.name() + ", " + each.from.identity() + '}';
    names.push_back(each.what);
    numbers.emplace_back(seed, each.what.name());
    orders.emplace_back(random_stream(~seed, each.what.name()), count);
  }
  identity += "}, " + std::to_string(seed) + ')';
  if (count == 0) return runs::mistaken("a study requires at least one run");
  if (count > max_runs) return runs::mistaken(name + " has more than 2^53 runs");
  auto draw = [=, what = std::move(what), numbers = std::move(numbers),
               orders = std::move(orders)](std::size_t run, double* values) {
    for (std::size_t i = 0; i < what.size(); ++i) {
      double part = numbers[i].number(run);
      if (stratified)
        part = std::clamp((static_cast<double>(orders[i](run)) + part) / static_cast<double>(count), 0x1p-53,
                          1 - 0x1p-53);
      values[i] = what[i].from.quantile(part);
    }
  };
  return {count, std::move(names), std::move(draw), std::move(identity)};
}

/// Returns the name and the bits of a column.
inline std::string identity_of(const std::string& name, const std::vector<double>& numbers) {
  bytes_writer all;
  all.put(numbers);
  return ' ' + name + ' ' + all.bytes();
}

} // namespace ensembles

KANEXPR_ENSEMBLES runs::runs(std::size_t count, std::vector<varied_name> what, plan values,
                             std::string identity)
    : size_(count), varied_(std::move(what)), plan_(std::move(values)), identity_(std::move(identity)),
      mistake_(ensembles::mistake_in(varied_)) {}

KANEXPR_ENSEMBLES runs runs::mistaken(std::string mistake) {
  runs none;
  none.size_ = 0;
  none.mistake_ = std::move(mistake);
  return none;
}

KANEXPR_ENSEMBLES std::vector<double> evenly_spaced(double first, double last, std::size_t count) {
  if (count > std::size_t{1} << 32) return {};
  std::vector<double> values(count, first);
  for (std::size_t i = 1; i < count; ++i)
    values[i] = ensembles::lerp(first, last, static_cast<double>(i) / static_cast<double>(count - 1));
  return values;
}

KANEXPR_ENSEMBLES runs grid(std::vector<grid_axis> axes) {
  std::size_t count = 1;
  std::vector<varied_name> names;
  std::string identity = "grid";
  for (const grid_axis& each : axes) {
    if (each.values.empty()) return runs::mistaken("the grid has no values for " + each.what.name());
    if (count > ensembles::max_runs / each.values.size())
      return runs::mistaken("the grid has more than 2^53 runs");
    count *= each.values.size();
    names.push_back(each.what);
    identity += ensembles::identity_of(each.what.name(), each.values);
  }
  const auto combine = [all = std::move(axes)](std::size_t run, double* values) {
    for (std::size_t i = all.size(); i-- > 0; run /= all[i].values.size())
      values[i] = all[i].values[run % all[i].values.size()];
  };
  return {count, std::move(names), combine, std::move(identity)};
}

KANEXPR_ENSEMBLES runs random_runs(std::size_t count, std::vector<drawn> what, std::uint64_t seed) {
  return ensembles::drawn_runs(count, std::move(what), seed, false);
}

KANEXPR_ENSEMBLES runs latin_hypercube(std::size_t count, std::vector<drawn> what, std::uint64_t seed) {
  return ensembles::drawn_runs(count, std::move(what), seed, true);
}

KANEXPR_ENSEMBLES runs runs_of(const table& rows, const std::vector<factor>& factors) {
  if (!rows) return runs::mistaken(rows.cause());
  if (rows.rows() == 0) return runs::mistaken("the table of runs has no rows");
  std::vector<varied_name> names;
  std::string identity = "table";
  for (const std::string& name : rows.names()) {
    if (std::ranges::find(factors, name, &factor::name) != factors.end())
      names.emplace_back(factor{name});
    else
      names.emplace_back(name);
    identity += ensembles::identity_of(name, rows.values(names.size() - 1));
  }
  for (const factor& each : factors)
    if (std::ranges::find(rows.names(), each.name) == rows.names().end())
      return runs::mistaken("the table of runs has no column " + each.name);
  const auto look_up = [rows](std::size_t run, double* values) {
    for (std::size_t i = 0; i < rows.columns(); ++i) values[i] = rows.values(i)[run];
  };
  return {rows.rows(), std::move(names), look_up, std::move(identity)};
}

} // namespace kanexpr
