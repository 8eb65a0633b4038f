#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>
#include <kanexpr/mechanics/units/unit_relations.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/operation.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>
#include <kanexpr/symbolic/printing/short_text.hpp>
#include <kanexpr/units/unit.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <initializer_list>
#include <string_view>

namespace kanexpr::mechanics {

/// The units of the nodes for which they were formed.
class unit_forms {
public:
  constexpr bool has(int id) const { return id < place_of_form_.size() && place_of_form_[id] != none; }
  /// The form of a node that has one.
  constexpr const unit_product& operator[](int id) const { return forms_[place_of_form_[id]]; }
  /// `nodes` is the number of all nodes.
  constexpr void set(int id, const unit_product& form, int nodes) {
    if (id >= place_of_form_.size()) place_of_form_.resize(nodes, none);
    place_of_form_[id] = forms_.push(form);
  }

private:
  sequence<unit_product> forms_{};
  sequence<int> place_of_form_{}; ///< by node
};

/// The first mistake in the units of a model, in words: what does not fit, and what determined its unit.
class unit_sentences {
public:
  constexpr unit_sentences(const symbolic::graph& g, unit_relations& relations, const unit_forms& forms)
      : g_(g), relations_(relations), forms_(forms) {}
  unit_sentences(const unit_sentences&) = delete;
  unit_sentences& operator=(const unit_sentences&) = delete;

  constexpr const sentence& mistake() const { return mistake_; }
  constexpr void set_mistake(const sentence& to) { mistake_ = to; }

  /// Names the part of the model that the next sentences describe.
  constexpr void describe(std::initializer_list<std::string_view> subject) {
    composed_ = sentence(subject);
    describe(composed_.view(), {});
  }
  constexpr void describe(std::string_view what, std::string_view whose) {
    what_ = what, whose_ = whose;
    ++described_;
  }

  /// Records that the part described last determines an unknown unit.
  constexpr void note_solved(int unknown) {
    if (reason_of_.size() < relations_.size()) reason_of_.resize(relations_.size(), none);
    if (reason_described_ != described_) reasons_.push(sentence({what_, whose_}));
    reason_described_ = described_;
    reason_of_[unknown] = reasons_.size() - 1;
  }

  static constexpr base::name text_of(const units::unit& u) {
    return units::text_of(u, units::spelling::message);
  }

  constexpr void fail(std::initializer_list<std::string_view> pieces) {
    if (!mistake_) mistake_ = sentence(pieces);
  }

  constexpr void fail_by_unit(int id, const unit_product& found, const units::unit& wanted) {
    const bool is_number = wanted == units::dimensionless;
    fail({what_, whose_, " is ", with_unit(id, found).view(),
          is_number ? ", but must be a number" : ", but must be in ", is_number ? "" : text_of(wanted).view(),
          origin_of_unit(id).view()});
  }

  /// The words before and between two quantities.
  struct wording {
    std::string_view before, between;
  };
  constexpr void fail_by_pair(const wording& how, int a, const unit_product& left, int b,
                              const unit_product& right) {
    const unit_product ratio = relations_.resolved(relations_.quotient(right, left));
    const bool are_known = relations_.resolved(left).is_known();
    fail({what_, whose_, how.before, with_unit(a, left).view(), how.between, with_unit(b, right).view(),
          are_known ? "" : ", whose units differ by a factor of ",
          are_known ? "" : text_of(ratio.known).view(), origin_of_unit(b, a).view()});
  }

  constexpr void fail_by_argument(int function, int id, const unit_product& found, bool is_angle) {
    fail({what_, whose_, " contains ", symbolic::short_text(g_, function).view(), "; ",
          with_unit(id, found).view(), is_angle ? " is not an angle" : " is not a number",
          origin_of_unit(id).view()});
  }

private:
  using operation = symbolic::operation;

  /// An expression with its unit in brackets; without one if its unit is not known.
  constexpr sentence with_unit(int id, const unit_product& u) {
    const unit_product found = relations_.resolved(u);
    const symbolic::short_text text(g_, id);
    if (!found.is_known()) return sentence({text.view()});
    return sentence({text.view(), " [", text_of(found.known).view(), "]"});
  }

  /// Explains a unit: "; the factor 0.3 has no unit" if an expression has a factor that may be meant to have
  /// one, otherwise the unit of the first parameter or input whose unit the model does not state: "; c is in
  /// N s/m by the force at P". Empty if there is none, or if the present part of the model determines it.
  constexpr sentence origin_of_unit(int id, int other = symbolic::graph::zero) {
    for (const int each : {id, other})
      if (const int factor = factor_in(each); factor != none)
        return sentence({"; the factor ", symbolic::short_text(g_, factor).view(), " has no unit"});
    const sentence found = origin_in(id);
    return found ? found : origin_in(other);
  }
  /// The first number among the factors of a product, except ratios such as 1/2 and small integers.
  constexpr int factor_in(int id) const {
    sequence<char> is_seen(g_.size(), 0);
    return factor_in(id, is_seen);
  }
  /// Shared parts are searched once.
  constexpr int factor_in(int id, sequence<char>& is_seen) const {
    if (is_seen[id] != 0) return none;
    is_seen[id] = 1;
    const symbolic::node& n = g_[id];
    if (n.op == operation::negate || n.op == operation::divide) return factor_in(n.a, is_seen);
    if (n.op == operation::multiply) {
      const int found = factor_in(n.a, is_seen);
      return found != none ? found : factor_in(n.b, is_seen);
    }
    if (n.op != operation::constant) return none;
    const symbolic::number& value = g_.number_at(id);
    if (value.exact() && value.numerator < 5 && value.numerator > -5) return none;
    return id;
  }
  constexpr sentence origin_in(int id) {
    sequence<char> is_seen(g_.size(), 0);
    return origin_in(id, is_seen);
  }
  constexpr sentence origin_in(int id, sequence<char>& is_seen) {
    if (is_seen[id] != 0) return {};
    is_seen[id] = 1;
    const symbolic::node& n = g_[id];
    if (n.op == operation::constant) return {};
    if (n.op == operation::symbol) return origin_of_symbol(id);
    sentence found = origin_in(n.a, is_seen);
    if (!found && symbolic::is_binary(n.op) && !symbolic::has_index_operand(n.op))
      found = origin_in(n.b, is_seen);
    return found;
  }
  constexpr sentence origin_of_symbol(int id) {
    const symbolic::symbol_kind kind = g_.symbol_at(id).kind;
    if (kind != symbolic::symbol_kind::parameter && kind != symbolic::symbol_kind::input) return {};
    if (!forms_.has(id) || forms_[id].unknowns != 1) return {};
    const int unknown = relations_.unknown(forms_[id], 0).of;
    if (!relations_.is_solved(unknown) || unknown >= reason_of_.size() || reason_of_[unknown] == none)
      return {};
    const std::string_view reason = reasons_[reason_of_[unknown]].view();
    const unit_product u = relations_.resolved(forms_[id]);
    if (reason.empty() || reason == sentence({what_, whose_}).view() || !u.is_known()) return {};
    return sentence(
        {"; ", g_.symbol_at(id).called.view(), " is in ", text_of(u.known).view(), " by ", reason});
  }

  const symbolic::graph& g_;
  unit_relations& relations_;
  const unit_forms& forms_;
  std::string_view what_{}, whose_{}; ///< the part of the model that is described
  sentence composed_{}, mistake_{};
  int described_ = 0,
      reason_described_ = 0;     ///< numbers of descriptions: the present one, that of the last reason
  sequence<sentence> reasons_{}; ///< the parts of the model that determine units
  sequence<int> reason_of_{};    ///< by unknown unit
};

} // namespace kanexpr::mechanics
