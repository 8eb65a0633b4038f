#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/simulations/trim/trim.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <string>
#include <string_view>
#include <vector>

/// The search for operating points.
namespace kanexpr::simulations {

/// An equation that holds at an operating point: it specifies the value of a rate, or of the residual of a
/// norm or constraint.
struct condition {
  int place = 0; ///< in [norms of quaternions; constraints; ẋ]
  double wanted = 0;
};

/// The unknowns and the equations of an operating point, selected by name. The symbols are numbered as in a
/// survey: [x; p; r].
class conditions {
public:
  conditions(const derivation::survey& known, const describe::system_record& record, std::string_view system,
             const requirements& asked)
      : known_(known), record_(record), system_(system), states_(known.coordinates + known.speeds),
        residuals_(known.quaternions + known.configuration_constraints + known.constraints) {
    const std::vector<bool> held = read(asked.held, "held"), freed = read(asked.freed, "freed"),
                            changing = read(asked.changing, "changing");
    for (int place = 0; place < known_.symbols(); ++place) {
      const auto i = static_cast<std::size_t>(place);
      if (held[i] && freed[i]) fail({called(place).view(), " is both held and freed"});
      if (changing[i] && place >= states_)
        fail({called(place).view(), " is listed as changing, but it is not part of the state"});
      if (freed[i] || (is_free_by_itself(place) && !held[i])) unknowns_.push_back(place);
    }
    for (int i = 0; i < residuals_; ++i) equations_.push_back({i, 0});
    add_rates(changing, asked.rates);
  }

  const std::vector<int>& unknowns() const { return unknowns_; }
  const std::vector<condition>& equations() const { return equations_; }
  const derivation::survey& known() const { return known_; }
  int states() const { return states_; }
  int residuals() const { return residuals_; }

  /// Returns a message that describes a mistake in the names.
  const base::sentence& mistake() const { return mistake_; }

  /// Returns the name of an equation: "configuration constraint 1", "the rate of speed u1".
  std::string name_of(const condition& c) const {
    const int norms = known_.quaternions, configuration = norms + known_.configuration_constraints;
    if (c.place < norms) return "the norm of quaternion " + std::to_string(c.place + 1);
    if (c.place < configuration) return "configuration constraint " + std::to_string(c.place - norms + 1);
    if (c.place < residuals_) return "velocity constraint " + std::to_string(c.place - configuration + 1);
    return rate_of(c.place - residuals_);
  }

private:
  std::string rate_of(int state) const {
    const bool is_of_motion = state >= known_.coordinates && state < known_.first_state_variable();
    if (!is_of_motion || !known_.takes_rates_as_speeds)
      return "the rate of " + std::string(called(state).view());
    return "the second derivative of " + std::string(called(state - known_.coordinates).view());
  }

  std::vector<bool> read(const std::vector<symbol_name>& names, std::string_view as) {
    std::vector<bool> named(static_cast<std::size_t>(known_.symbols()));
    for (const symbol_name& each : names) {
      const int place = place_of(each.name());
      if (place < 0) {
        fail({each.name(), " is listed as ", as, ", but the system ", system_, " does not have it"});
        continue;
      }
      const auto i = static_cast<std::size_t>(place);
      if (named[i]) fail({called(place).view(), " is listed twice as ", as});
      named[i] = true;
    }
    return named;
  }

  void add_rates(std::vector<bool> changing, const std::vector<named_value>& rates) {
    std::vector<bool> given(static_cast<std::size_t>(states_));
    for (const named_value& rate : rates) {
      const int place = place_of_rate(rate.what.name());
      if (place < 0) {
        fail({rate.what.name(), " is given as a rate, but it is not a rate of the system ", system_});
        continue;
      }
      const auto i = static_cast<std::size_t>(place);
      if (given[i]) fail({rate_of(place), " is given twice"});
      if (!numeric::is_finite(rate.value)) fail({"the value given for ", rate_of(place), " is not finite"});
      given[i] = changing[i] = true;
      equations_.push_back({residuals_ + place, rate.value});
    }
    for (int place = 0; place < states_; ++place)
      if (!changing[static_cast<std::size_t>(place)]) equations_.push_back({residuals_ + place, 0});
  }

  bool is_free_by_itself(int place) const {
    if (place < states_) return true;
    const int input = place - known_.first_of(symbolic::symbol_kind::input);
    return input >= 0 && !is_prescribed(input);
  }

  /// Whether an input is prescribed as a function of time, as determined by the list of inputs or, if there
  /// is none, by the presence of its derivatives.
  bool is_prescribed(int input) const {
    if (input < record_.inputs.size)
      return record_.inputs[input].tokens[0].symbol->order != describe::unprescribed;
    const std::string name(known_.names[known_.first_of(symbolic::symbol_kind::input) + input].view());
    return name.ends_with('\'') || place_of(name + "'") >= 0;
  }

  int place_of(std::string_view name) const {
    for (int place = 0; place < known_.symbols(); ++place)
      if (known_.names[place].view() == name) return place;
    return -1;
  }
  int place_of_rate(std::string_view name) const {
    if (!name.ends_with('\'')) return -1;
    const int place = place_of(name.substr(0, name.size() - 1));
    return place < states_ ? place : -1;
  }

  base::sentence called(int place) const { return compiled::symbol_called(known_, place); }

  void fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake_) mistake_ = base::sentence(pieces);
  }

  const derivation::survey& known_;
  const describe::system_record& record_;
  std::string_view system_;
  int states_, residuals_;
  std::vector<int> unknowns_{};
  std::vector<condition> equations_{};
  base::sentence mistake_{};
};

} // namespace kanexpr::simulations
