#pragma once

#include <kanexpr/exporting/casadi/casadi_function.hpp>
#include <kanexpr/exporting/casadi/kernels.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// Writes the functions that CasADi loads from a shared library, a column and its derivatives, as wrappers
/// around the C functions that compute them.
///
/// CasADi, core/external.cpp: a null argument means zero, a null result is not requested, and a nonzero
/// return value means that there is no result.
class casadi_file {
public:
  /// Exports the rates as the function `library`, or the residual as `library`_implicit. `kernels` has the
  /// functions of `casadi_kernels`.
  casadi_file(const std::string& library, bool of_residual, const exported_system& kernels,
              const std::vector<casadi_argument>& arguments)
      : library_(library), begin_(casadi_kernels::begin_of_names(of_residual)), kernels_(kernels),
        arguments_(arguments), basic_(count_of_basic(arguments)),
        family_{library + (of_residual ? "_implicit" : ""), of_residual ? "residual" : "rate",
                arguments[0].size, arguments} {
    const int states = arguments[0].size;
    for (const casadi_argument& each : arguments) {
      const std::string result = "by_" + each.name;
      family_.first.push_back(shape_of("jacobian", result, states, each.size));
      family_.along.push_back(shape_of("directional_jacobian", result, states, each.size));
      family_.second.emplace_back();
      for (const casadi_argument& other : arguments)
        family_.second.back().push_back(
            shape_of("hessian", result + '_' + other.name, each.size, other.size));
    }
  }

  std::string text() const {
    std::string all;
    for (const casadi_function& each :
         {column(), jacobian(), forward(), jacobian_of_forward(), adjoint(), jacobian_of_adjoint()})
      all += each.text(library_);
    return all;
  }

private:
  /// A result of a C function, and its place in CasADi's results.
  struct requested_output {
    std::size_t place = 0; ///< index in `res`
    int entries = 0;
    bool is_basic = false; ///< available without the derivatives with respect to all arguments
  };

  bool has_more() const { return kernels_.function(begin_ + "jacobian_by_all") != nullptr; }

  /// The sparsity of a result; empty if the result is missing because the system has no such arguments.
  casadi_sparsity shape_of(const std::string& function, const std::string& result, int rows,
                           int columns) const {
    for (const exported_result& each :
         kernels_.function(begin_ + function + (has_more() ? "_by_all" : ""))->results)
      if (each.name == result) return casadi_sparsity::of(each);
    return casadi_sparsity::empty(rows, columns);
  }

  static std::string arg(std::size_t i) { return "arg[" + std::to_string(i) + ']'; }
  static std::string res(std::size_t i) { return "res[" + std::to_string(i) + ']'; }
  std::string argument_at(std::size_t place) const { return library_ + "_given(" + arg(place) + ')'; }
  std::string weights() const { return argument_at(arguments_.size() + 1); }

  /// The name of the C function for a derivative, or for the column itself.
  std::string kernel(const std::string& derivative) const {
    return derivative.empty() ? casadi_kernels::name_of_column(!begin_.empty()) : begin_ + derivative;
  }

  /// Returns the call of a C function as a condition that is true if there is no result.
  std::string call(const std::string& function, const std::string& weights,
                   const std::vector<std::string>& results) const {
    std::string text, time = "0";
    for (symbols each : {symbols::state, symbols::parameters, symbols::inputs, symbols::rates})
      for (std::size_t i = 0; i < arguments_.size(); ++i)
        if (arguments_[i].are == each) text += ", " + argument_at(i);
    if (arguments_.back().are == symbols::time) time = '*' + argument_at(arguments_.size() - 1);
    text = kernels_.name + '_' + kernel(function) + '(' + time + text;
    if (kernels_.function(kernel(function))->weights > 0) text += ", " + weights;
    for (const std::string& each : results) text += ", " + each;
    return text + ") != 0";
  }

  /// Returns the call of the function for the basic arguments if it suffices, that is, if no other result is
  /// requested and `needs_more` is zero. Results that are not requested are written to `w`, starting at
  /// `scratch`.
  std::string call_for(const std::string& function, const std::string& weights,
                       const std::vector<requested_output>& all, int scratch = 0,
                       std::string needs_more = {}) const {
    std::vector<std::string> basic, more;
    for (const requested_output& each : all) {
      const std::string to = library_ + "_or(" + res(each.place) + ", w + " + std::to_string(scratch) + ')';
      scratch += each.entries;
      more.push_back(to);
      if (each.is_basic)
        basic.push_back(to);
      else
        needs_more += (needs_more.empty() ? "" : " || ") + res(each.place);
    }
    std::string least = call(function, weights, basic);
    if (!has_more()) return least;
    return '(' + needs_more + ")\n    ? " + call(function + "_by_all", weights, more) + "\n    : " + least;
  }

  static std::string any_of(const std::vector<requested_output>& all) {
    return joined(all, " || ", [](const requested_output& each) { return res(each.place); });
  }

  static int entries_of(const std::vector<requested_output>& all) {
    int count = 0;
    for (const requested_output& each : all) count += each.entries;
    return count;
  }

  casadi_function column() const {
    casadi_function f = family_.value();
    f.body = "  (void)w;\n  if (!res[0]) return 0;\n  return " + call("", "", {"res[0]"}) + ";\n";
    return f;
  }

  /// The derivatives with respect to each argument, which are the results starting at `place`.
  std::vector<requested_output> first_derivatives(std::size_t place) const {
    std::vector<requested_output> all;
    all.reserve(arguments_.size());
    for (std::size_t i = 0; i < arguments_.size(); ++i)
      all.push_back({place + i, family_.first[i].entries(), i < basic_});
    return all;
  }

  casadi_function jacobian() const {
    casadi_function f = family_.jacobian();
    const std::vector<requested_output> all = first_derivatives(0);
    f.scratch = entries_of(all);
    f.body = "  return " + call_for("jacobian", "", all) + ";\n";
    return f;
  }

  /// Declares `i` and, if some arguments are not basic, `more`, which is nonzero if the direction has nonzero
  /// entries for these. The direction fills the first entries of `w`.
  std::string take_direction(int& size_of_all) const {
    std::string text = has_more() ? "  long long i;\n  int more = 0;\n" : "  long long i;\n";
    for (std::size_t k = 0; k < arguments_.size(); ++k) {
      const int size = arguments_[k].size;
      if (size == 0) continue;
      const auto for_each = [&](std::string_view what) {
        text += fill_template(what, {{"size", std::to_string(size)},
                                     {"begin", std::to_string(size_of_all)},
                                     {"from", arg(arguments_.size() + 1 + k)}});
      };
      for_each("  for (i = 0; i < @size@; ++i) w[@begin@ + i] = @from@ ? @from@[i] : 0;\n");
      if (k >= basic_) for_each("  for (i = 0; i < @size@; ++i) more |= w[@begin@ + i] != 0;\n");
      size_of_all += size;
    }
    return text;
  }

  casadi_function forward() const {
    casadi_function f = family_.forward();
    f.body = take_direction(f.scratch) + "  if (!res[0]) return 0;\n";
    if (has_more()) f.body += "  if (more) return " + call("directional_by_all", "w", {"res[0]"}) + ";\n";
    f.body += "  return " + call("directional", "w", {"res[0]"}) + ";\n";
    return f;
  }

  /// The derivatives of the directional derivative with respect to each argument, to the column (these are
  /// zero) and to the direction (these are the first derivatives).
  casadi_function jacobian_of_forward() const {
    casadi_function f = family_.jacobian_of_forward();
    int direction = 0;
    f.body = take_direction(direction);
    std::vector<requested_output> second;
    second.reserve(arguments_.size());
    for (std::size_t i = 0; i < arguments_.size(); ++i)
      second.push_back({i, family_.along[i].entries(), i < basic_});
    const std::vector<requested_output> first = first_derivatives(arguments_.size() + 1);
    f.scratch = direction + (std::max)(entries_of(first), entries_of(second));
    f.body += "  if ((" + any_of(first) + ") && (" + call_for("jacobian", "", first, direction) +
              ")) return 1;\n  if (!(" + any_of(second) + ")) return 0;\n  return " +
              call_for("directional_jacobian", "w", second, direction, "more") + ";\n";
    return f;
  }

  casadi_function adjoint() const {
    casadi_function f = family_.adjoint();
    std::vector<requested_output> all;
    for (std::size_t i = 0; i < arguments_.size(); ++i)
      if (arguments_[i].size > 0) all.push_back({i, arguments_[i].size, i < basic_});
    f.scratch = entries_of(all);
    f.body = "  return " + call_for("gradient", weights(), all) + ";\n";
    return f;
  }

  /// The derivatives of each adjoint with respect to each argument, to the column (these are zero) and to the
  /// weights (these are the transposed first derivatives).
  casadi_function jacobian_of_adjoint() const {
    casadi_function f = family_.jacobian_of_adjoint();
    std::vector<requested_output> second;
    for (std::size_t o = 0; o < arguments_.size(); ++o)
      for (std::size_t i = 0; i < arguments_.size(); ++i)
        second.push_back(
            {o * (arguments_.size() + 2) + i, family_.second[o][i].entries(), o < basic_ && i < basic_});
    f.scratch = (std::max)(entries_of(second), entries_of(first_derivatives(0)));
    f.body = transposed_jacobian() + "  if (!(" + any_of(second) + ")) return 0;\n  return " +
             call_for("hessian", weights(), second) + ";\n";
    return f;
  }

  /// Returns the code for the derivatives of the adjoints with respect to the weights; it uses `w` as scratch
  /// space.
  std::string transposed_jacobian() const {
    std::string wanted, more, taken;
    std::vector<std::string> to, basic;
    int begin = 0;
    for (std::size_t o = 0; o < arguments_.size(); ++o) {
      to.push_back("w + " + std::to_string(begin));
      if (o < basic_) basic = to;
      if (family_.first[o].entries() == 0) continue;
      const std::size_t place = (o + 1) * (arguments_.size() + 2) - 1;
      (o < basic_ ? wanted : more) += " || " + res(place);
      taken += fill_template(R"(    if (@to@) {
      static const int from[] = {@from@};
      for (i = 0; i < @size@; ++i) @to@[i] = w[@begin@ + from[i]];
    }
)",
                             {{"to", res(place)},
                              {"from", joined(family_.first[o].transposed().second, ", ")},
                              {"size", std::to_string(family_.first[o].entries())},
                              {"begin", std::to_string(begin)}});
      begin += family_.first[o].entries();
    }
    std::string computed = call("jacobian", "", basic);
    if (!more.empty())
      computed = more.substr(4) + " ? " + call("jacobian_by_all", "", to) + "\n        : " + computed;
    return "  if (" + (wanted + more).substr(4) + ") {\n    long long i;\n    if (" + computed +
           ") return 1;\n" + taken + "  }\n";
  }

  std::string library_, begin_;
  const exported_system& kernels_;
  const std::vector<casadi_argument>& arguments_;
  std::size_t basic_;
  casadi_family family_;
};

} // namespace kanexpr::exporting
