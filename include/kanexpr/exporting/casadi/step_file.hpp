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
  casadi_step(const std::string& library, const steps::tableau& method, const exported_system& kernels,
              const std::vector<casadi_argument>& arguments)
      : step_writer(library, method, kernels, arguments), family_{name_, "next", n(), given_} {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      family_.first.push_back(block(shapes_.first, 0, n(), i));
      family_.along.push_back(block(shapes_.along, 0, n(), i));
      family_.second.emplace_back();
      for (std::size_t k = 0; k < given_.size(); ++k)
        family_.second.back().push_back(block(shapes_.second, begin_[i], given_[i].size, k));
    }
  }

  std::string text() const {
    std::string all = in(step_template);
    for (const casadi_function& each :
         {value(), jacobian(), forward(), jacobian_of_forward(), adjoint(), jacobian_of_adjoint()})
      all += each.text(library_);
    return all;
  }

private:
  /// The pattern of the rows starting at `first_row` and of the columns of argument `by`.
  casadi_sparsity block(const pattern& all, int first_row, int rows, std::size_t by) const {
    casadi_sparsity found = casadi_sparsity::empty(rows, given_[by].size);
    for (int j = 0; j < found.columns; ++j)
      for (int i = 0; i < rows; ++i)
        if (all(first_row + i, begin_[by] + j)) found.places.emplace_back(j, i);
    return found;
  }

  /// Returns the code that copies result `place`, if it is requested, from the matrix `all` of the
  /// derivatives with respect to all arguments; `index` returns the index of an entry in this matrix.
  template <class Index>
  static std::string copied(const casadi_function& f, std::size_t place, const std::string& all,
                            const Index& index) {
    std::vector<int> from;
    for (const auto& [column, row] : f.out[place].shape.places) from.push_back(index(row, column));
    if (from.empty()) return {};
    return fill_template(template_part(step_functions_template, "copy"),
                         {{"place", std::to_string(place)},
                          {"from", joined(from, ", ")},
                          {"size", std::to_string(from.size())},
                          {"all", all}});
  }
  /// Copies derivatives of the next state with respect to argument `by`.
  std::string copied_first(const casadi_function& f, std::size_t place, const std::string& all,
                           std::size_t by) const {
    return copied(f, place, all, [&](int row, int column) { return row * columns_ + begin_[by] + column; });
  }

  /// Returns the C condition under which one of these results is requested.
  static std::string any_of(const std::vector<std::size_t>& places) {
    if (places.empty()) return "0";
    return joined(places, " || ", [](std::size_t each) { return "res[" + std::to_string(each) + "] != 0"; });
  }

  int size_of_points() const { return 2 * stages() * n(); }
  int size_of_moved() const {
    return size_of_points() + stages() * slope_.size() + (stages() + 2) * n() * columns_;
  }

  casadi_function value() const {
    casadi_function f = family_.value();
    f.scratch = size_of_points();
    f.body = part("value");
    return f;
  }

  casadi_function jacobian() const {
    casadi_function f = family_.jacobian();
    std::vector<std::size_t> more;
    std::string gather;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_basic(i)) more.push_back(i);
      gather += copied_first(f, i, "after", i);
    }
    f.scratch = size_of_moved();
    f.body =
        "  const int by_all = " + any_of(more) + ";\n  int i;\n" + part("moved") + gather + "  return 0;\n";
    return f;
  }

  casadi_function forward() const {
    casadi_function f = family_.forward();
    f.scratch = size_of_points() + columns_ + 2 * n();
    f.body = part("forward");
    return f;
  }

  casadi_function jacobian_of_forward() const {
    casadi_function f = family_.jacobian_of_forward();
    const std::size_t first_by_direction = given_.size() + 1;
    std::vector<std::size_t> more;
    std::string along, first;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_basic(i)) more.push_back(i), more.push_back(first_by_direction + i);
      along += copied_first(f, i, "total", i);
      first += copied_first(f, first_by_direction + i, "after", i);
    }
    f.scratch = size_of_moved() + 3 * n() * columns_ + columns_ + n() + bend_.size();
    f.body = "  int i, s, c, e, by_all = " + any_of(more) + ";\n" + part("moved_along") + along + first +
             "  return 0;\n";
    return f;
  }

  casadi_function adjoint() const {
    casadi_function f = family_.adjoint();
    std::vector<std::size_t> more;
    std::string gather;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_basic(i)) more.push_back(i);
      gather +=
          fill_template("  if (res[@i@])\n    for (i = 0; i < @size@; ++i) res[@i@][i] = sum[@begin@ + i];\n",
                        {{"i", std::to_string(i)},
                         {"size", std::to_string(given_[i].size)},
                         {"begin", std::to_string(begin_[i])}});
    }
    f.scratch = size_of_points() + 2 * n() + 2 * columns_;
    f.body = "  const int by_all = " + any_of(more) + ";\n" + part("adjoint") + gather + "  return 0;\n";
    return f;
  }

  casadi_function jacobian_of_adjoint() const {
    casadi_function f = family_.jacobian_of_adjoint();
    std::vector<std::size_t> second, more;
    std::string gather;
    for (std::size_t o = 0, place = 0; o < given_.size(); ++o) {
      for (std::size_t i = 0; i < given_.size(); ++i, ++place) {
        second.push_back(place);
        if (!is_basic(o) || !is_basic(i)) more.push_back(place);
        // the entries below the diagonal are not computed
        gather += copied(f, place, "rest", [&](int row, int column) {
          const auto [first, last] = std::minmax({begin_[o] + row, begin_[i] + column});
          return first * columns_ + last;
        });
      }
      const std::size_t by_weights = ++place;
      if (!is_basic(o)) more.push_back(by_weights);
      gather += copied(f, by_weights, "after",
                       [&](int row, int column) { return column * columns_ + begin_[o] + row; });
      ++place;
    }
    f.scratch = size_of_moved() + 2 * columns_ * columns_ + 2 * n() + columns_ + curve_.size();
    f.body = "  const int by_all = " + any_of(more) + ";\n  int i;\n" + part("moved") + "  if ((" +
             any_of(second) + part("curved") + gather + "  return 0;\n";
    return f;
  }

  casadi_family family_;
};

} // namespace kanexpr::exporting
