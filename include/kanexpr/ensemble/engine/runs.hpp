#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/base/digits.hpp>
#include <kanexpr/ensemble/between.hpp>
#include <kanexpr/ensemble/permutation.hpp>
#include <kanexpr/ensemble/runs.hpp>

#include <algorithm>
#include <cmath>

namespace kanexpr {

namespace ensembles {

/// Their numbers stand in a column.
inline constexpr std::size_t most_runs = std::size_t{1} << 53;

/// Values that a run has in each column.
class combined final : public runs::plan {
public:
  explicit combined(std::vector<grid_axis> axes) : axes_(std::move(axes)) {}
  void values(std::size_t run, double* out) const override {
    for (std::size_t i = axes_.size(); i-- > 0;) {
      out[i] = axes_[i].values[run % axes_[i].values.size()];
      run /= axes_[i].values.size();
    }
  }

private:
  std::vector<grid_axis> axes_;
};

class from_table final : public runs::plan {
public:
  explicit from_table(table rows) : rows_(std::move(rows)) {}
  void values(std::size_t run, double* out) const override {
    for (std::size_t i = 0; i < rows_.columns(); ++i) out[i] = rows_.values(i)[run];
  }

private:
  table rows_;
};

/// Draws of each value, from anywhere or, `spread`, from a range of its own.
class random final : public runs::plan {
public:
  random(std::size_t count, std::vector<drawn> what, std::uint64_t seed, bool spread)
      : count_(count), spread_(spread), what_(std::move(what)) {
    for (const drawn& each : what_) {
      numbers_.emplace_back(seed, each.what.name());
      orders_.emplace_back(random_stream(~seed, each.what.name()), count);
    }
  }
  void values(std::size_t run, double* out) const override {
    for (std::size_t i = 0; i < what_.size(); ++i) {
      double part = numbers_[i].number(run);
      if (spread_) {
        const auto range = static_cast<double>(orders_[i](run));
        part = std::clamp((range + part) / static_cast<double>(count_), 0x1p-53, 1 - 0x1p-53);
      }
      out[i] = what_[i].from.quantile(part);
    }
  }

private:
  std::size_t count_;
  bool spread_;
  std::vector<drawn> what_;
  std::vector<random_stream> numbers_{};
  std::vector<permutation> orders_{};
};

inline std::string mistake_in(const std::vector<varied_name>& what) {
  for (std::size_t i = 0; i < what.size(); ++i) {
    if (what[i].name().empty()) return "what differs from run to run has no name";
    for (std::size_t k = 0; k < i; ++k)
      if (what[k].name() == what[i].name()) return what[i].name() + " differs from run to run twice over";
  }
  return {};
}

inline runs drawn_runs(std::size_t count, std::vector<drawn> what, std::uint64_t seed, bool spread) {
  const std::string name = spread ? "latin_hypercube" : "random_runs";
  std::string text = name + '(' + std::to_string(count) + ", {";
  std::vector<varied_name> names;
  for (const drawn& each : what) {
    if (!each.from.mistake().empty()) return runs::mistaken(each.from.mistake());
    text += (names.empty() ? "{" : ", {") + each.what.name() + ", " + each.from.text() + '}';
    names.push_back(each.what);
  }
  text += "}, " + std::to_string(seed) + ')';
  if (count == 0) return runs::mistaken("a study needs a run at least");
  if (count > most_runs) return runs::mistaken(name + " has more runs than can be counted");
  return {count, std::move(names), std::make_shared<random>(count, std::move(what), seed, spread),
          std::move(text)};
}

/// Numbers by their bits, by which a study is known again.
inline std::string bits_of(const std::vector<double>& numbers) {
  bytes_writer all;
  all.put(numbers);
  return all.bytes();
}

} // namespace ensembles

KANEXPR_ENSEMBLES runs::runs(std::size_t count, std::vector<varied_name> what,
                             std::shared_ptr<const plan> values, std::string text)
    : size_(count), varied_(std::move(what)), plan_(std::move(values)), text_(std::move(text)),
      mistake_(ensembles::mistake_in(varied_)) {}

KANEXPR_ENSEMBLES runs runs::mistaken(std::string mistake) {
  runs none;
  none.size_ = 0;
  none.mistake_ = std::move(mistake);
  return none;
}

KANEXPR_ENSEMBLES std::vector<double> evenly_spaced(double first, double last, std::size_t count) {
  constexpr std::size_t most = std::size_t{1} << 32; // a negative number is beyond it
  if (count > most) return {};
  std::vector<double> values(count, first);
  for (std::size_t i = 1; i < count; ++i)
    values[i] = ensembles::between(first, last, static_cast<double>(i) / static_cast<double>(count - 1));
  return values;
}

KANEXPR_ENSEMBLES runs grid(std::vector<grid_axis> axes) {
  std::size_t count = 1;
  std::vector<varied_name> names;
  std::string text = "grid";
  for (const grid_axis& each : axes) {
    if (each.values.empty()) return runs::mistaken("the grid has no values of " + each.what.name());
    if (count > ensembles::most_runs / each.values.size())
      return runs::mistaken("the grid has more runs than can be counted");
    count *= each.values.size();
    names.push_back(each.what);
    text += ' ' + each.what.name() + ' ' + ensembles::bits_of(each.values);
  }
  return {count, std::move(names), std::make_shared<ensembles::combined>(std::move(axes)), std::move(text)};
}

KANEXPR_ENSEMBLES runs random_runs(std::size_t count, std::vector<drawn> what, std::uint64_t seed) {
  return ensembles::drawn_runs(count, std::move(what), seed, false);
}

KANEXPR_ENSEMBLES runs latin_hypercube(std::size_t count, std::vector<drawn> what, std::uint64_t seed) {
  return ensembles::drawn_runs(count, std::move(what), seed, true);
}

KANEXPR_ENSEMBLES runs runs_of(const table& given, const std::vector<factor>& factors) {
  if (!given) return runs::mistaken(given.cause());
  if (given.rows() == 0) return runs::mistaken("the table of runs has no row");
  std::vector<varied_name> names;
  std::string text = "table";
  for (const std::string& name : given.names()) {
    if (std::ranges::any_of(factors, [&](const factor& f) { return f.name == name; }))
      names.emplace_back(factor{name});
    else
      names.emplace_back(name);
    text += ' ' + name + ' ' + ensembles::bits_of(given.values(names.size() - 1));
  }
  for (const factor& each : factors)
    if (std::ranges::find(given.names(), each.name) == given.names().end())
      return runs::mistaken("the table of runs has no column " + each.name);
  return {given.rows(), std::move(names), std::make_shared<ensembles::from_table>(given), std::move(text)};
}

} // namespace kanexpr
