#pragma once

#include <kanexpr/exporting/casadi/casadi_function.hpp>
#include <kanexpr/exporting/casadi/step_writer.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace kanexpr::exporting {

/// Writes a step of fixed length as a CasADi function, `library`_step(x, r, p, h), and its derivatives, based
/// on the C functions that compute the rates and their derivatives.
class casadi_step : private step_writer {
public:
  using step_writer::step_writer;

  std::string text() const {
    std::string all = in(casadi_templates::step) + in(casadi_templates::second_order_of_step);
    for (const casadi_function& each :
         {value(), jacobian(), forward(), jacobian_of_forward(), adjoint(), jacobian_of_adjoint()})
      all += each.text(library_);
    return all;
  }

private:
  casadi_port next(const std::string& before) const { return {before + "next", casadi_sparsity::dense(n())}; }
  void add_given(std::vector<casadi_port>& to, const std::string& before) const {
    for (const casadi_argument& each : given_)
      to.push_back({before + each.name, casadi_sparsity::dense(each.size)});
  }
  casadi_function named(const std::string& before) const {
    casadi_function f{.name = before + name_};
    add_given(f.in, "");
    if (!before.empty()) f.in.push_back(next("out_"));
    return f;
  }

  /// A block of derivatives, with the index of each entry in the full matrix.
  struct block {
    casadi_sparsity shape{};
    std::vector<int> from{};
  };

  /// The derivatives of the next state or of an adjoint by argument `by`.
  block by_given(const pattern& all, int first_row, int rows, std::size_t by) const {
    block found{casadi_sparsity::empty(rows, given_[by].size), {}};
    for (int j = 0; j < given_[by].size; ++j)
      for (int i = 0; i < rows; ++i) {
        const int row = first_row + i, column = begin_[by] + j;
        if (!all(row, column)) continue;
        found.shape.places.emplace_back(j, i);
        const bool is_below = &all == &shapes_.second && row > column; // which is not computed
        found.from.push_back(is_below ? column * columns_ + row : row * columns_ + column);
      }
    return found;
  }
  block first_by(std::size_t by) const { return by_given(shapes_.first, 0, n(), by); }

  block transposed_first_by(std::size_t by) const {
    block found{casadi_sparsity::empty(given_[by].size, n()), {}};
    for (int i = 0; i < n(); ++i)
      for (int j = 0; j < given_[by].size; ++j)
        if (shapes_.first(i, begin_[by] + j)) {
          found.shape.places.emplace_back(i, j);
          found.from.push_back(i * columns_ + begin_[by] + j);
        }
    return found;
  }

  /// Adds a result and returns the code that copies it if it is requested.
  static std::string add(casadi_function& to, const std::string& name, const block& one,
                         const std::string& all) {
    const std::string place = std::to_string(to.out.size());
    to.out.push_back({name, one.shape});
    if (one.from.empty()) return {};
    return fill_template(R"(  if (res[@place@]) {
    static const int from[] = {@from@};
    for (i = 0; i < @size@; ++i) res[@place@][i] = @all@[from[i]];
  }
)",
                         {{"place", place},
                          {"from", casadi_function::listed(one.from)},
                          {"size", std::to_string(one.from.size())},
                          {"all", all}});
  }

  /// The C condition that one of these results is requested.
  static std::string any_of(const std::vector<std::size_t>& places) {
    std::string text;
    for (std::size_t each : places)
      text += (text.empty() ? "res[" : " || res[") + std::to_string(each) + "] != 0";
    return text.empty() ? "0" : text;
  }

  int size_of_points() const { return 2 * stages() * n(); }
  int size_of_moved() const {
    return size_of_points() + stages() * slope_.size() + (stages() + 2) * n() * columns_;
  }

  casadi_function value() const {
    casadi_function f = named("");
    f.out.push_back(next(""));
    f.scratch = size_of_points();
    f.body = in(R"(  const @s@_arguments given = @s@_take(arg), *const at = &given;
  int i, s;
  if (!res[0]) return 0;
  if (@s@_points(at, w)) return 1;
  for (i = 0; i < @s@_n; ++i) {
    double after = at->x[i];
    for (s = 0; s < @s@_stages; ++s) after += @s@_b_of(s, i) * at->h * w[(2 * s + 1) * @s@_n + i];
    res[0][i] = after;
  }
  return 0;
)");
    return f;
  }

  casadi_function jacobian() const {
    casadi_function f = named("jac_");
    std::vector<std::size_t> more;
    std::string gather;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_basic(i)) more.push_back(i);
      gather += add(f, "jac_next_" + given_[i].name, first_by(i), "after");
    }
    f.scratch = size_of_moved();
    f.body = "  const int by_all = " + any_of(more) + ";\n  int i;\n" + in(casadi_templates::moved) + gather +
             "  return 0;\n";
    return f;
  }

  casadi_function forward() const {
    casadi_function f = named("fwd1_");
    add_given(f.in, "fwd_");
    f.out.push_back(next("fwd_"));
    f.scratch = size_of_points() + columns_ + 2 * n();
    f.body = in(R"(  const @s@_arguments given = @s@_take(arg), *const at = &given;
  double *direction = w + 2 * @s@_stages * @s@_n, *rate_along = direction + @s@_columns, *sum = rate_along + @s@_n;
  int i, s, by_all = 0;
@take_direction@  (void)by_all;
  if (!res[0]) return 0;
  if (@s@_points(at, w)) return 1;
  for (i = 0; i < @s@_n; ++i) sum[i] = along_x[i];
  for (s = 0; s < @s@_stages; ++s) {
@directed@@directional@    for (i = 0; i < @s@_n; ++i) sum[i] += @s@_b_of(s, i) * (at->h * rate_along[i] + along_h * y[@s@_n + i]);
  }
  for (i = 0; i < @s@_n; ++i) res[0][i] = sum[i];
  return 0;
)");
    return f;
  }

  /// The derivatives by the arguments, by the next state (zero) and by the direction.
  casadi_function jacobian_of_forward() const {
    casadi_function f = named("jac_fwd1_");
    add_given(f.in, "fwd_");
    f.in.push_back(next("out_fwd_"));
    std::vector<std::size_t> more;
    std::string gather;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_basic(i)) more.push_back(i), more.push_back(given_.size() + 1 + i);
      gather += add(f, "jac_fwd_next_" + given_[i].name, by_given(shapes_.along, 0, n(), i), "total");
    }
    f.out.push_back({"jac_fwd_next_out_next", casadi_sparsity::empty(n(), n())});
    for (std::size_t i = 0; i < given_.size(); ++i)
      gather += add(f, "jac_fwd_next_fwd_" + given_[i].name, first_by(i), "after");
    f.scratch = size_of_moved() + 3 * n() * columns_ + columns_ + n() + bend_.size();
    f.body = "  int i, s, c, e, by_all = " + any_of(more) + ";\n" + in(casadi_templates::moved_along) +
             gather + "  return 0;\n";
    return f;
  }

  casadi_function adjoint() const {
    casadi_function f = named("adj1_");
    f.in.push_back(next("adj_"));
    std::vector<std::size_t> more;
    std::string gather;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_basic(i)) more.push_back(i);
      f.out.push_back({"adj_" + given_[i].name, casadi_sparsity::dense(given_[i].size)});
      gather +=
          fill_template("  if (res[@i@])\n    for (i = 0; i < @size@; ++i) res[@i@][i] = sum[@begin@ + i];\n",
                        {{"i", std::to_string(i)},
                         {"size", std::to_string(given_[i].size)},
                         {"begin", std::to_string(begin_[i])}});
    }
    f.scratch = size_of_points() + 2 * n() + 2 * columns_;
    f.body = "  const int by_all = " + any_of(more) + ";\n" +
             in(R"(  const @s@_arguments given = @s@_take(arg), *const at = &given;
  const double *weights = @weights@;
  double *weight = w + 2 * @s@_stages * @s@_n, *of_next = weight + @s@_n, *gradient = of_next + @s@_n,
         *sum = gradient + @s@_columns;
  int i, s;
  (void)by_all;
  if (@s@_points(at, w)) return 1;
  for (i = 0; i < @s@_columns; ++i) gradient[i] = 0, sum[i] = i < @s@_n ? weights[i] : 0;
  for (s = @s@_stages - 1; s >= 0; --s) {
    const double *y = w + 2 * s * @s@_n;
    const double t = at->t + @s@_when[s] * at->h;
    @s@_weigh(s, weights, of_next, weight);
@gradient@@turn@    for (i = 0; i < @s@_columns; ++i) sum[i] += at->h * gradient[i];
    for (i = 0; i < @s@_n; ++i) {
      sum[@s@_h] += weight[i] * y[@s@_n + i];
      of_next[i] = at->h * gradient[i];
    }
  }
)") + gather +
             "  return 0;\n";
    return f;
  }

  /// The derivatives by the arguments, by the next state (zero) and by the weights.
  casadi_function jacobian_of_adjoint() const {
    casadi_function f = named("jac_adj1_");
    f.in.push_back(next("adj_"));
    add_given(f.in, "out_adj_");
    std::vector<std::size_t> second, more;
    std::string gather;
    for (std::size_t o = 0; o < given_.size(); ++o) {
      const std::string begin = "jac_adj_" + given_[o].name + '_';
      for (std::size_t i = 0; i < given_.size(); ++i) {
        second.push_back(f.out.size());
        if (!is_basic(o) || !is_basic(i)) more.push_back(f.out.size());
        gather +=
            add(f, begin + given_[i].name, by_given(shapes_.second, begin_[o], given_[o].size, i), "rest");
      }
      f.out.push_back({begin + "out_next", casadi_sparsity::empty(given_[o].size, n())});
      if (!is_basic(o)) more.push_back(f.out.size());
      gather += add(f, begin + "adj_next", transposed_first_by(o), "after");
    }
    f.scratch = size_of_moved() + 2 * columns_ * columns_ + 2 * n() + columns_ + curve_.size();
    f.body = "  const int by_all = " + any_of(more) + ";\n  int i;\n" + in(casadi_templates::moved) +
             "  if ((" + any_of(second) +
             in(") &&\n      @s@_curved(at, by_all, w, slopes, by, @weights@, rest, rest + @s@_columns * "
                "@s@_columns))\n"
                "    return 1;\n") +
             gather + "  return 0;\n";
    return f;
  }
};

} // namespace kanexpr::exporting
