#pragma once

#include <kanexpr/exporting/export_request.hpp>
#include <kanexpr/exporting/exported_system.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::exporting {

inline constexpr std::string_view casadi_function_template = template_text(
#include <kanexpr/exporting/casadi/function.c.in>
);

/// The sparsity of an input or output of a CasADi function: dense, or the positions of its entries in column
/// order.
struct casadi_sparsity {
  int rows = 0, columns = 0;
  bool is_dense = false;
  std::vector<std::pair<int, int>> places{}; ///< column and row

  static casadi_sparsity dense(int rows) { return {rows, 1, true, {}}; }
  static casadi_sparsity empty(int rows, int columns) { return {rows, columns, false, {}}; }
  static casadi_sparsity of(const exported_result& result) {
    return {result.rows, result.columns, false, result.places};
  }

  int entries() const { return is_dense ? rows * columns : static_cast<int>(places.size()); }

  /// Returns the transpose, and for each of its entries the index in this pattern.
  std::pair<casadi_sparsity, std::vector<int>> transposed() const {
    std::vector<std::pair<std::pair<int, int>, int>> exchanged;
    exchanged.reserve(places.size());
    for (const auto& [column, row] : places)
      exchanged.push_back({{row, column}, static_cast<int>(exchanged.size())});
    std::sort(exchanged.begin(), exchanged.end());
    casadi_sparsity found = empty(columns, rows);
    std::vector<int> from;
    for (const auto& [place, before] : exchanged) {
      found.places.push_back(place);
      from.push_back(before);
    }
    return {found, from};
  }

  /// The encoding that CasADi reads: rows, columns and 1, or compressed columns.
  std::vector<int> numbers() const {
    std::vector<int> all{rows, columns};
    if (is_dense) {
      all.push_back(1);
      return all;
    }
    std::size_t next = 0;
    for (int j = 0; j <= columns; ++j) {
      while (next < places.size() && places[next].first < j) ++next;
      all.push_back(static_cast<int>(next));
    }
    for (const auto& place : places) all.push_back(place.second);
    return all;
  }
};

/// An input or output of a function.
struct casadi_port {
  std::string name{};
  casadi_sparsity shape{};
};

/// A function in a shared library with the names and shapes that CasADi queries.
struct casadi_function {
  std::string name{};
  std::vector<casadi_port> in{}, out{};
  int scratch = 0;    ///< number of entries of `w`
  std::string body{}; ///< code in terms of `arg`, `res` and `w`; returns nonzero if there is no result

  /// `library` is the prefix of the names that all functions share.
  std::string text(const std::string& library) const {
    return fill_template(
        casadi_function_template,
        {{"name", name},
         {"library", library},
         {"body", body},
         {"entries",
          joined(out, ", ", [](const casadi_port& each) { return std::to_string(each.shape.entries()); })},
         {"n_in", std::to_string(in.size())},
         {"n_out", std::to_string(out.size())},
         {"names_in", names(in)},
         {"names_out", names(out)},
         {"shapes_in", shapes(in)},
         {"shapes_out", shapes(out)},
         {"scratch", std::to_string(scratch)}});
  }

private:
  static std::string names(const std::vector<casadi_port>& ports) {
    return joined(ports, ", ", [](const casadi_port& each) { return '"' + each.name + '"'; });
  }

  static std::string shapes(const std::vector<casadi_port>& ports) {
    std::vector<int> begins{0};
    for (const casadi_port& each : ports)
      begins.push_back(begins.back() + static_cast<int>(each.shape.numbers().size()));
    begins.pop_back();
    return "  static const int begin[] = {" + joined(begins, ", ") +
           "};\n  static const long long shapes[] = {\n    " +
           joined(ports, ",\n    ",
                  [](const casadi_port& each) { return joined(each.shape.numbers(), ", "); }) +
           "};";
  }
};

/// An argument of a CasADi function: the state x, its rates, the inputs r, the parameters p, the time t, or
/// the step length h.
struct casadi_argument {
  std::string name{};
  symbols are{};
  int size = 0;

  /// False for parameters and time, which come last: derivatives with respect to them are computed only on
  /// request.
  bool is_basic() const { return are != symbols::parameters && are != symbols::time; }
};

/// The names, inputs and outputs of a function that returns a column y, and of the functions that CasADi
/// looks up for its derivatives. CasADi also passes y to the latter; derivatives with respect to it are zero.
/// The caller adds the bodies.
struct casadi_family {
  std::string name{}, column{};
  int rows = 0; ///< of y
  std::vector<casadi_argument> arguments{};
  std::vector<casadi_sparsity> first{}, along{};      ///< ∂y/∂z and ∂((∂y/∂z) w)/∂z for each argument z
  std::vector<std::vector<casadi_sparsity>> second{}; ///< ∂²(λᵀy)/∂z∂z'

  casadi_function value() const {
    casadi_function f{.name = name, .out = {of_column("")}};
    add_arguments(f.in, "");
    return f;
  }

  casadi_function jacobian() const {
    casadi_function f = derivative("jac_");
    for (std::size_t i = 0; i < arguments.size(); ++i)
      f.out.push_back({"jac_" + column + '_' + arguments[i].name, first[i]});
    return f;
  }

  casadi_function forward() const {
    casadi_function f = derivative("fwd1_");
    add_arguments(f.in, "fwd_");
    f.out.push_back(of_column("fwd_"));
    return f;
  }

  casadi_function jacobian_of_forward() const {
    casadi_function f = derivative("jac_fwd1_");
    add_arguments(f.in, "fwd_");
    f.in.push_back(of_column("out_fwd_"));
    const std::string begin = "jac_fwd_" + column + '_';
    for (std::size_t i = 0; i < arguments.size(); ++i) f.out.push_back({begin + arguments[i].name, along[i]});
    f.out.push_back({begin + "out_" + column, casadi_sparsity::empty(rows, rows)});
    for (std::size_t i = 0; i < arguments.size(); ++i)
      f.out.push_back({begin + "fwd_" + arguments[i].name, first[i]});
    return f;
  }

  casadi_function adjoint() const {
    casadi_function f = derivative("adj1_");
    f.in.push_back(of_column("adj_"));
    add_arguments(f.out, "adj_");
    return f;
  }

  casadi_function jacobian_of_adjoint() const {
    casadi_function f = derivative("jac_adj1_");
    f.in.push_back(of_column("adj_"));
    add_arguments(f.in, "out_adj_");
    for (std::size_t o = 0; o < arguments.size(); ++o) {
      const std::string begin = "jac_adj_" + arguments[o].name + '_';
      for (std::size_t i = 0; i < arguments.size(); ++i)
        f.out.push_back({begin + arguments[i].name, second[o][i]});
      f.out.push_back({begin + "out_" + column, casadi_sparsity::empty(arguments[o].size, rows)});
      f.out.push_back({begin + "adj_" + column, first[o].transposed().first});
    }
    return f;
  }

private:
  casadi_function derivative(const std::string& before) const {
    casadi_function f{.name = before + name};
    add_arguments(f.in, "");
    f.in.push_back(of_column("out_"));
    return f;
  }
  casadi_port of_column(const std::string& before) const {
    return {before + column, casadi_sparsity::dense(rows)};
  }
  void add_arguments(std::vector<casadi_port>& to, const std::string& before) const {
    for (const casadi_argument& each : arguments)
      to.push_back({before + each.name, casadi_sparsity::dense(each.size)});
  }
};

} // namespace kanexpr::exporting
