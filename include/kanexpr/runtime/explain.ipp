#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/derived_system.hpp>
#include <kanexpr/derivation/extract_code.hpp>
#include <kanexpr/derivation/request.hpp>
#include <kanexpr/derivation/stages.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/lower/tape_cost.hpp>
#include <kanexpr/mechanics/dynamics/absolute_speeds.hpp>
#include <kanexpr/mechanics/equations.hpp>
#include <kanexpr/mechanics/model/formulation.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/multibody_system.hpp>
#include <kanexpr/mechanics/quantity.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/runtime/explain.hpp>
#include <kanexpr/runtime/formulation_search.hpp>
#include <kanexpr/runtime/speeds_in_ground.hpp>
#include <kanexpr/runtime/system_expressions.ipp>
#include <kanexpr/symbolic/cost.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::runtime {

namespace detail {

/// The forms of one system, formed one after another.
class comparison_of_forms {
public:
  comparison_of_forms(forming form, const explain_options& options)
      : form_(std::move(form)), options_(options) {}
  comparison_of_forms(const comparison_of_forms&) = delete;
  comparison_of_forms& operator=(const comparison_of_forms&) = delete;

  explanation run() {
    if (options_.weights && options_.weights->is_negative_for_any())
      return {.mistake = "the options of explain give an operation a negative weight"};
    if (options_.results.empty()) return {.mistake = "the options of explain list no result"};
    found_.mistake = form_({}, [&](mechanics::equations& e, const symbolic::cost& c) { look_at(e, c); });
    if (!found_.mistake.empty()) return found_;
    compare_solutions("", form_of_model());
    for (const auto& [called, axes] : {std::pair{"axes of each body", &axes_of_system::body::own},
                                       std::pair{"axes of the body below", &axes_of_system::body::below}})
      compare_solutions(called, in_axes(axes));
    compare_solutions("axes of the ground", in_axes(nullptr));
    compare_solutions("about the mass centers", about_centers());
    mechanics::formulation absolute = form_of_model();
    absolute.speeds = mechanics::internal_speeds::absolute;
    if (no_absolute_.empty())
      compare_solutions("absolute speeds", absolute);
    else
      found_.candidates.push_back({.called = "absolute speeds", .cause = no_absolute_});
    if (options_.searches) search();
    for (std::size_t i = 1; i < found_.candidates.size(); ++i)
      if (found_.candidates[i].applies() && found_.candidates[i].weighted < found_.best().weighted)
        found_.cheapest = i;
    compare_dependent_speeds();
    return std::move(found_);
  }

private:
  using solution = mechanics::solution;

  /// Notes the form of the model and what the candidates need to know about the system.
  void look_at(mechanics::equations& e, const symbolic::cost& c) {
    const mechanics::skeleton& s = e.skeleton_used();
    const mechanics::mechanism& m = *s.model;
    const mechanics::formulation& given = m.formulated;
    stated_weights_ = given.weights;
    weights_ = options_.weights.value_or(given.weights);
    const bool is_stated = !given.frames.empty() || given.solved_by != solution::cheapest ||
                           given.speeds != mechanics::internal_speeds::given;
    found_.weights = weights_;
    found_.candidates.push_back({is_stated ? "as the model states" : "chosen by the library", "", c,
                                 c.weighted(weights_), given, ""});
    for (const mechanics::frame& f : m.frames) frames_.emplace_back(f.called.view());
    for (const mechanics::expression& u : m.speeds)
      speeds_.emplace_back(m.g->symbol_at(u.node()).called.view());
    dependent_ = e.speeds().dependent;
    bodies_ = axes_of_system(s, options_.may_use).bodies;
    no_search_ = axes_of_system(s, {}).bodies.empty() ? "no body rotates"
                                                      : "may_use excludes the axes of all bodies that rotate";
    if (m.derived_by == mechanics::method::lagrange)
      no_tree_ = "its equations are derived by Lagrange's method";
    else if (!dependent_.empty())
      no_tree_ = "it has constraints";
    else if (!s.flexible_parts.empty())
      no_tree_ = "a body is flexible";
    if (no_tree_.empty() && !counts_solution()) no_tree_ = "only udot and rhs depend on it";
    no_absolute_ = no_tree_;
    const bool is_any_absolute = no_tree_.empty() && mechanics::absolute_speeds(s).is_any();
    if (no_tree_.empty() && !is_any_absolute)
      no_absolute_ = has_speeds_from_ground(s)
                         ? "bodies that rotate about parallel axes of the ground have absolute speeds already"
                         : "no two bodies, one on the other, rotate about parallel axes of the ground, each "
                           "at a speed of its own";
    if (!counts_solution()) return;
    const bool is_absolute = given.speeds == mechanics::internal_speeds::absolute && is_any_absolute;
    const bool by_bodies =
        e.has_other_form() && (!is_absolute || given.solved_by == solution::articulated_bodies);
    found_.solved_by = by_bodies ? solution::articulated_bodies : solution::elimination;
  }

  /// With the weights of the model, which also determine choices of the library other than these.
  mechanics::formulation form_of_model() const {
    mechanics::formulation form;
    form.weights = stated_weights_;
    return form;
  }
  mechanics::formulation in_axes(int axes_of_system::body::* axes) const {
    mechanics::formulation form = form_of_model();
    for (const axes_of_system::body& b : bodies_)
      form.entry(b.frame).axes = axes == nullptr ? mechanics::mechanism::inertial : b.*axes;
    return form;
  }
  mechanics::formulation about_centers() const {
    mechanics::formulation form = form_of_model();
    for (const axes_of_system::body& b : bodies_)
      if (b.has_mass) form.entry(b.frame).about_the_center = true;
    return form;
  }

  /// Whether a result contains the solution of the equations; derivatives of u̇ are always solved with M.
  bool counts_solution() const {
    return std::ranges::any_of(options_.results, [](mechanics::quantity each) {
      return each == mechanics::quantity::udot || each == mechanics::quantity::rhs;
    });
  }

  static std::string named(const std::string& variant, const std::string& solved) {
    return variant.empty() ? solved : variant + ", " + solved;
  }
  void compare_solutions(const std::string& variant, mechanics::formulation form) {
    form.solved_by = solution::elimination;
    add(named(variant, "by elimination"), form);
    form.solved_by = solution::articulated_bodies;
    if (no_tree_.empty())
      add(named(variant, "by articulated bodies"), form);
    else if (variant.empty())
      found_.candidates.push_back({.called = "by articulated bodies", .cause = no_tree_});
  }

  void search() {
    if (bodies_.empty()) {
      found_.candidates.push_back({.called = "axes and points by search", .cause = no_search_});
      return;
    }
    formulation_search from(form_, bodies_, weights_);
    for (const auto speeds : {mechanics::internal_speeds::given, mechanics::internal_speeds::absolute}) {
      const bool is_absolute = speeds == mechanics::internal_speeds::absolute;
      if (is_absolute && !no_absolute_.empty()) continue;
      for (const solution by : {solution::elimination, solution::articulated_bodies}) {
        if (by == solution::articulated_bodies && !no_tree_.empty()) continue;
        mechanics::formulation form = form_of_model();
        form.solved_by = by, form.speeds = speeds;
        add(std::string("axes and points by search, ") + (is_absolute ? "absolute speeds, " : "") +
                (by == solution::elimination ? "by elimination" : "by articulated bodies"),
            from.cheapest_from(form));
      }
    }
  }

  /// The cheapest other choices of the speeds for which the constraints are solved. They change the states at
  /// which this is impossible, so they are listed, but never recommended.
  void compare_dependent_speeds() {
    constexpr std::size_t most_shown = 3;
    const std::string cause = dependent_.empty()       ? "it has no constraints"
                              : !options_.searches     ? "the options omit searches"
                              : has_too_many_choices() ? "there are more than 400 choices"
                                                       : "";
    if (!cause.empty()) {
      found_.candidates.push_back(
          {.called = "other dependent speeds", .cause = cause, .is_left_out = !dependent_.empty()});
      return;
    }
    std::vector<formulation_candidate> others;
    sequence<int> chosen;
    for (int i = 0; i < dependent_.size(); ++i) chosen.push(i);
    do {
      if (std::equal(chosen.begin(), chosen.end(), dependent_.begin())) continue;
      formulation_candidate c{.form = found_.chosen().form};
      c.cause = form_({c.form, chosen, false}, [&](mechanics::equations&, const symbolic::cost& counted) {
        c.cost = counted, c.weighted = counted.weighted(weights_);
      });
      if (!c.applies()) continue;
      for (int i : chosen) c.word += (c.word.empty() ? "dependent<" : ", ") + speeds_[at(i)];
      c.word += ">";
      c.called = c.word;
      others.push_back(c);
    } while (advance(chosen));
    if (others.empty())
      found_.candidates.push_back(
          {.called = "other dependent speeds", .cause = "the constraints can be solved for no others"});
    std::sort(others.begin(), others.end(), [](const auto& a, const auto& b) {
      return a.weighted != b.weighted ? a.weighted < b.weighted : a.word < b.word;
    });
    others.resize((std::min)(others.size(), most_shown));
    for (const formulation_candidate& c : others) found_.candidates.push_back(c);
  }

  /// Each choice takes the time of a derivation.
  bool has_too_many_choices() const {
    constexpr long long most = 400;
    const long long fixed = static_cast<long long>(speeds_.size()) - dependent_.size();
    long long choices = 1; // binomial coefficients, which increase
    for (int i = 1; i <= dependent_.size() && choices <= most; ++i) choices = choices * (fixed + i) / i;
    return choices > most;
  }
  /// Replaces a choice of speeds by the next one in lexicographic order; false after the last one.
  bool advance(sequence<int>& chosen) const {
    const int speeds = static_cast<int>(speeds_.size()), count = chosen.size();
    int i = count - 1;
    while (i >= 0 && chosen[i] == speeds - count + i) --i;
    if (i < 0) return false;
    for (int next = chosen[i] + 1; i < count; ++i) chosen[i] = next++;
    return true;
  }

  void add(const std::string& called, const mechanics::formulation& form) {
    formulation_candidate c{.called = called, .form = form};
    c.cause = form_({form, {}, false}, [&](mechanics::equations&, const symbolic::cost& counted) {
      c.cost = counted, c.weighted = counted.weighted(weights_);
    });
    c.word = word_of(form);
    found_.candidates.push_back(c);
  }

  std::string word_of(const mechanics::formulation& form) const {
    std::string parts;
    const auto part = [&](const std::string& one) { parts += (parts.empty() ? "" : ", ") + one; };
    for (const mechanics::formulation_of_frame& f : form.frames) {
      if (f.axes >= 0) part("written_in<" + frames_[at(f.frame)] + ", " + frames_[at(f.axes)] + ">");
      if (f.about_the_center) part("about_mass_center<" + frames_[at(f.frame)] + ">");
    }
    if (form.speeds == mechanics::internal_speeds::absolute) part("in_absolute_speeds");
    if (form.solved_by == solution::elimination && no_tree_.empty()) part("by_elimination");
    if (form.solved_by == solution::articulated_bodies) part("by_articulated_bodies");
    if (!parts.empty() && stated_weights_ != symbolic::operation_weights{})
      part(runtime::word_of(stated_weights_));
    return parts.empty() ? "" : "formulation<" + parts + ">";
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  const forming form_;
  const explain_options& options_;
  symbolic::operation_weights weights_{}, stated_weights_{};
  explanation found_{};
  std::vector<std::string> frames_{}, speeds_{};
  sequence<int> dependent_{};
  std::vector<axes_of_system::body> bodies_{};
  std::string no_search_{};               ///< why the axes of no body can be varied
  std::string no_tree_{}, no_absolute_{}; ///< why the equations are not those of a tree, or of a planar one
};

/// "multipliers has no entries".
inline std::string lack_of_entries(const explain_options& options) {
  std::string names;
  for (const mechanics::quantity one : options.results)
    names.append(names.empty() ? "" : ", ").append(mechanics::row_of(one).called);
  return names + (options.results.size() == 1 ? " has no entries" : " have no entries");
}

inline std::vector<derivation::request> requests_of(const explain_options& options) {
  std::vector<derivation::request> all;
  all.reserve(options.results.size());
  for (const mechanics::quantity one : options.results)
    all.push_back({.what = derivation::request::kind::result, .wanted = one});
  return all;
}

} // namespace detail

KANEXPR_ENGINE std::string word_of(const symbolic::operation_weights& weights) {
  symbolic::operation_weights standard;
  standard.fused = weights.multiplication + weights.addition;
  std::string parts;
  for (const auto& [called, weight] : symbolic::weighted_operations)
    if (weights.*weight != standard.*weight)
      parts += std::string(parts.empty() ? "." : ", .") + called + " = " + std::to_string(weights.*weight);
  return "weighted_by<operation_weights{" + parts + "}>";
}

KANEXPR_ENGINE explanation explain_types(const derivation::checked_words& from,
                                         const explain_options& options) {
  if (from.mistake) return {.mistake = from.mistake.cause()};
  const std::vector<derivation::request> all = detail::requests_of(options);
  const auto form = [&](const formed_system& how, const auto& use) -> std::string {
    derivation::derived_system system(from.record);
    if (!how.as_given) system.formulate(how.form, how.dependent_speeds);
    derivation::advance(system, derivation::stage::constrained);
    if (system.mistake()) return system.mistake().cause();
    const derivation::needed_nodes needed = derivation::nodes_for(system, all);
    if (system.mistake()) return system.mistake().cause();
    if (needed.nodes.empty()) return detail::lack_of_entries(options);
    use(system.equations(), lower::cost_of(lower::tape_of(system.graph(), needed.nodes)));
    return {};
  };
  return detail::comparison_of_forms(form, options).run();
}

} // namespace kanexpr::runtime

namespace kanexpr {

KANEXPR_ENGINE explanation explain(const runtime::builder& built, const explain_options& options) {
  if (const base::sentence mistake = (built.check)()) return {.mistake = mistake.cause()};
  const auto form = [&](const runtime::formed_system& how, const auto& use) -> std::string {
    symbolic::graph own;
    mechanics::multibody_system system(built.system());
    runtime::copy_to_graph(own, system);
    if (!how.as_given) system.mechanism.formulated = how.form;
    if (!how.dependent_speeds.empty()) system.constraints.dependent_speeds = how.dependent_speeds;
    mechanics::equations e(system);
    e.constrain();
    base::sequence<int> nodes;
    for (const mechanics::quantity wanted : options.results)
      if (!e.mistake()) nodes.append(symbolic::nodes_of(e.get(wanted).entries));
    if (e.mistake()) return e.mistake().cause();
    if (nodes.empty()) return runtime::detail::lack_of_entries(options);
    for (const mechanics::singularity_check& each : e.singularity_checks_of(nodes))
      nodes.push(each.measure.node()), nodes.push(each.scale.node());
    use(e, lower::cost_of(lower::tape_of(own, nodes)));
    return {};
  };
  return runtime::detail::comparison_of_forms(form, options).run();
}

} // namespace kanexpr
