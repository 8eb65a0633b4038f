#pragma once

#include <kanexpr/exporting/casadi/step_shapes.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>
#include <kanexpr/exporting/text/scalar.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// C code for the steps of CasADi. `@s@` is the prefix of a step's names. Each column of its derivatives
/// belongs to an entry of the arguments x, r, h, p and t, in this order, so that the derivatives that do not
/// involve parameters come first.
///
/// The second derivatives ∂²(λᵀ x⁺)/∂z² are the sum over the stages of Wᵀ H W, where W are the derivatives of
/// the stage's arguments and H the weighted second derivatives of its rates, plus the terms from the product
/// of h and the rates.
inline constexpr std::string_view step_template = template_text(
#include <kanexpr/exporting/casadi/step.c.in>
);

/// The function bodies of a step. `moved` computes the points, slopes and derivatives of all stages; `after`
/// holds those of the step, and `rest` is scratch space. `moved_along` computes the derivatives `total` of a
/// directional derivative: the derivatives of a stage's rates follow from the second derivatives of the rates
/// along the stage's direction, and from the derivatives of that direction.
inline constexpr std::string_view step_functions_template = template_text(
#include <kanexpr/exporting/casadi/step_functions.c.in>
);

/// The common base of the functions of a step: the order of the derivatives, and the C functions that compute
/// those of the rates.
class step_writer {
public:
  /// `arguments` are those of the rates; `kernels` has the functions of `casadi_kernels`.
  step_writer(const std::string& library, const steps::tableau& method, const exported_system& kernels,
              const std::vector<casadi_argument>& arguments)
      : library_(library), name_(library + "_step"), method_(method), kernels_(kernels), of_rates_(arguments),
        given_(arguments) {
    given_.insert(given_.begin() + 3, {"h", {}, 1});
    h_ = n() + given_[1].size, columns_ = h_ + 1 + given_[2].size;
    begin_ = {0, n(), h_ + 1, h_};
    if (takes_time()) t_ = columns_, begin_.push_back(columns_++);
    const auto begin = [&](std::size_t i) { return begin_[i < 3 ? i : 4]; };
    for (std::size_t i = 0; i < of_rates_.size(); ++i) {
      take(slope_, "by_" + of_rates_[i].name, i < basic, 0, begin(i));
      take(bend_, "by_" + of_rates_[i].name, i < basic, 0, begin(i));
    }
    for (const bool are_basic : {true, false})
      for (std::size_t o = 0; o < of_rates_.size(); ++o)
        for (std::size_t i = 0; i < of_rates_.size(); ++i)
          if ((o < basic && i < basic) == are_basic)
            take(curve_, "by_" + of_rates_[o].name + '_' + of_rates_[i].name, are_basic, begin(o), begin(i));
    shapes_ = step_shapes(method, static_cast<int>(kernels.coordinates.size()), n(), columns_, h_, t_,
                          slope_.places, bend_.places, curve_.places);
  }

protected:
  static constexpr std::size_t basic = 2; ///< basic arguments of the rates: the state and the inputs

  /// The sparse results of a C function, one after another; those with respect to the state and the inputs
  /// come first.
  struct sparse_results {
    std::string function{};
    entry_places places{};
    std::size_t basic = 0; ///< number of basic entries
    std::map<std::string, std::size_t> begin{};

    int size() const { return static_cast<int>((std::max)(places.size(), std::size_t(1))); }
  };

  int n() const { return of_rates_[0].size; }
  int stages() const { return method_.stages; }
  bool takes_time() const { return of_rates_.size() > 3; }
  bool has_more() const { return columns_ > h_ + 1; }
  /// Whether the derivatives with respect to argument i do not require those of the rates with respect to
  /// parameters and time.
  bool is_basic(std::size_t i) const { return i < basic || (i == 3 && !takes_time()); }

  void take(sparse_results& into, const std::string& result, bool is_by_basic, int row, int column) const {
    into.begin[result] = into.places.size();
    for (const exported_result& each :
         kernels_.function(into.function + (has_more() ? "_by_all" : ""))->results)
      if (each.name == result)
        for (const auto& [j, i] : each.places) into.places.emplace_back(row + i, column + j);
    if (is_by_basic) into.basic = into.places.size();
  }

  // The C code

  static std::string number(std::size_t value) { return std::to_string(value); }
  static std::string number(int value) { return std::to_string(value); }
  static std::string number(double value) { return scalar(precision::double_precision).number(value); }
  static std::string pair(const std::string& first, const std::string& second) {
    return '{' + first + ", " + second + '}';
  }
  static std::string listed(const entry_places& places) {
    if (places.empty()) return pair("0", "0");
    return joined(places, ", ", [](const auto& at) { return pair(number(at.first), number(at.second)); });
  }
  std::string argument_at(std::size_t place) const { return library_ + "_given(arg[" + number(place) + "])"; }

  /// Returns the call of a C function; the generated code returns if it has no result. `given` is passed
  /// after the inputs.
  std::string call(const std::string& function, const std::string& given, const std::string& into,
                   const std::map<std::string, std::size_t>& begin) const {
    const auto one = [&](const std::string& called) {
      std::string text = kernels_.name + '_' + called + "(t, y, at->p, at->r" + given;
      for (const exported_result& each : kernels_.function(called)->results)
        text += ", " + into + " + " + number(begin.at(each.name));
      return text + ')';
    };
    const std::string what =
        has_more() ? "(by_all ? " + one(function + "_by_all") + " : " + one(function) + ')' : one(function);
    return "    if (" + what + " != 0) return 1;\n";
  }
  std::string call(const sparse_results& of, const std::string& given, const std::string& into) const {
    return call(of.function, given, into, of.begin);
  }

  std::string in_time(std::string_view text) const {
    return takes_time() ? fill_template(text, {{"s", name_}, {"t", number(t_)}}) : std::string();
  }

  /// Returns the code that reads the direction, in the order of the arguments of the rates, without the
  /// state.
  std::string direction_in_c() const {
    const std::size_t first = given_.size() + 1;
    std::string text =
        "  const double *along_x = " + argument_at(first) + ", along_h = *" + argument_at(first + 3) + ";\n";
    int begin = n();
    for (std::size_t i = 1; i < of_rates_.size(); ++i) {
      if (of_rates_[i].size == 0) continue;
      const auto for_each = [&](std::string_view what) {
        text += fill_template(what, {{"size", number(of_rates_[i].size)},
                                     {"begin", number(begin)},
                                     {"from", argument_at(first + (i < 3 ? i : 4))}});
      };
      for_each("  for (i = 0; i < @size@; ++i) direction[@begin@ + i] = @from@[i];\n");
      if (i >= basic) for_each("  for (i = 0; i < @size@; ++i) by_all |= direction[@begin@ + i] != 0;\n");
      begin += of_rates_[i].size;
    }
    return text + (takes_time() ? "  by_all |= along_h != 0;\n" : "");
  }

  /// Returns the code for the point of stage s and the direction there.
  std::string directed_in_c() const {
    std::string text = fill_template(template_part(step_functions_template, "directed"), {{"s", name_}});
    if (takes_time())
      text += fill_template("    direction[@s@_t - 1] = *@along_t@ + @s@_when[s] * along_h;\n",
                            {{"s", name_}, {"along_t", argument_at(given_.size() + 5)}});
    return text;
  }

  /// Returns a part of the function template with its placeholders filled in.
  std::string part(std::string_view name) const { return in(template_part(step_functions_template, name)); }

  std::string in(std::string_view text) const {
    std::string a, b, when;
    for (int stage = 0; stage < stages(); ++stage) {
      const steps::tableau::stage& each = method_.at(stage);
      const std::string between = a.empty() ? "" : ", ";
      a += between + pair(number(each.a[0]), number(each.a[1]));
      b += between + pair(number(each.b[0]), number(each.b[1]));
      when += between + number(each.c);
    }
    std::map<std::string, std::size_t> of_gradient;
    for (std::size_t i = 0; i < of_rates_.size(); ++i)
      of_gradient["by_" + of_rates_[i].name] = static_cast<std::size_t>(begin_[i < 3 ? i : 4]);
    return fill_template(text,
                         {{"s", name_},
                          {"n", number(n())},
                          {"h", number(h_)},
                          {"t", number(t_)},
                          {"columns", number(columns_)},
                          {"basic", number(h_ + 1)},
                          {"stages", number(stages())},
                          {"coordinates", number(kernels_.coordinates.size())},
                          {"slopes", number(slope_.size())},
                          {"basic_slopes", number(slope_.basic)},
                          {"curves", number(curve_.size())},
                          {"basic_curves", number(curve_.basic)},
                          {"bends", number(bend_.size())},
                          {"basic_bends", number(bend_.basic)},
                          {"slope_at", listed(slope_.places)},
                          {"curve_at", listed(curve_.places)},
                          {"bend_at", listed(bend_.places)},
                          {"a", a},
                          {"b", b},
                          {"when", when},
                          {"method", std::string(method_.title)},
                          {"given", library_ + "_given"},
                          {"time", takes_time() ? '*' + argument_at(4) : "0"},
                          {"kernels", kernels_.name},
                          {"jacobian", call(slope_, "", "slope")},
                          {"directional_jacobian", call(bend_, ", direction", "bend")},
                          {"directional", call("directional", ", direction", "rate_along", {{"rate", 0}})},
                          {"gradient", call("gradient", ", weight", "gradient", of_gradient)},
                          {"hessian", call(curve_, ", weight", "curve")},
                          {"all_bends", number(bend_.places.size())},
                          {"take_direction", direction_in_c()},
                          {"directed", directed_in_c()},
                          {"turn", in_time("    gradient[@s@_h] = @s@_when[s] * gradient[@s@_t];\n")},
                          {"turned", in_time(R"(    if (by_all)
      for (d = @s@_h; d < columns; ++d)
        all[@s@_h * @s@_columns + d] += @s@_when[s] * moved[@s@_t * @s@_columns + d];
)")},
                          {"weights", argument_at(given_.size() + 1)}});
  }

  std::string library_, name_;
  const steps::tableau& method_;
  const exported_system& kernels_;
  const std::vector<casadi_argument>& of_rates_;
  std::vector<casadi_argument> given_; ///< arguments of a step: x, r, p, h, t
  std::vector<int> begin_{};           ///< the first column of each argument
  int h_ = 0, t_ = -1, columns_ = 0;
  sparse_results slope_{.function = "jacobian"}, bend_{.function = "directional_jacobian"},
      curve_{.function = "hessian"};
  step_shapes shapes_{};
};

} // namespace kanexpr::exporting
