#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/derived_system.hpp>
#include <kanexpr/derivation/result_units.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/runtime/derived.ipp>
#include <kanexpr/runtime/model.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/linear/symmetric_columns.hpp>

#include <memory>
#include <string>
#include <vector>

namespace kanexpr {

namespace runtime {

inline std::string enumerated(derived& system, const base::sequence<symbolic::expression>& symbols,
                              const mechanics::partition& (mechanics::equations::*which)() const) {
  if (system.mistake()) return {};
  const base::sequence<int>& dependent = (system.equations()->*which)().dependent;
  std::string text;
  for (int i = 0; i < dependent.size(); ++i)
    text.append(mechanics::before_entry(i, dependent.size()))
        .append(mechanics::called(system.system().mechanism, symbols[dependent[i]]));
  return text;
}

/// Forms a result of a system without mistakes. A mistake in the request itself is reported; the next request
/// clears it.
template <class Form>
auto try_form(derived& system, const Form& form) {
  using result = decltype(form());
  system.request_mistake = {};
  if (system.mistake()) return result();
  const derivation::symbol_reader::count known = system.reader().symbols_known();
  const result found = form();
  if (system.reader().mistake()) {
    system.request_mistake = system.reader().mistake();
    system.reader().forget_mistake(known);
  }
  return system.request_mistake || system.mistake() ? result() : found;
}

/// Forms a result of a system through the same stages as at compile time.
inline symbolic::matrix form_result(derived& system, const derivation::request& wanted) {
  if (wanted.what == derivation::request::kind::result)
    system.request_mistake = system.equations()->check_bodies(wanted.wanted);
  if (system.request_mistake) return {};
  for (const derivation::stage next : {derivation::stage::equations, derivation::stage::linearized})
    if (derivation::stage_for(wanted) >= next && !system.equations()->mistake())
      derivation::advance(*system.equations(), next);
  derivation::visit({&wanted, 1}, system.reader());
  return derivation::form(wanted, system.reader(), *system.equations());
}

} // namespace runtime

KANEXPR_ENGINE model::model(const derivation::checked_words& from,
                            std::span<const derivation::request> extra_requests,
                            std::span<const std::uint64_t> expected_digests)
    : system_(std::make_shared<runtime::derived_from_types>(from, extra_requests, expected_digests)) {}

KANEXPR_ENGINE std::string model::mistake() const {
  return std::string((system_->mistake() ? system_->mistake() : system_->request_mistake).view());
}

KANEXPR_ENGINE std::string model::names_of_dependent_coordinates() {
  return runtime::enumerated(*system_, mechanism().coordinates, &mechanics::equations::coordinates);
}
KANEXPR_ENGINE std::string model::names_of_dependent_speeds() {
  return runtime::enumerated(*system_, mechanism().speeds, &mechanics::equations::speeds);
}

KANEXPR_ENGINE std::vector<std::string> model::names_of_inertial_parameters() const {
  std::vector<std::string> all;
  for (const base::name& each : mechanics::names_of_inertial_parameters(mechanism()))
    all.emplace_back(each.view());
  return all;
}

KANEXPR_ENGINE symbolic::matrix model::get(mechanics::quantity wanted) {
  return get({.what = derivation::request::kind::result, .wanted = wanted});
}

KANEXPR_ENGINE symbolic::matrix model::get(const derivation::request& wanted) {
  const symbolic::matrix found = runtime::try_form(
      *system_, [&] { return symbolic::written_out(runtime::form_result(*system_, wanted)); });
  if (wanted.is_of_linearization()) system_->note_linearization(found);
  return found;
}
KANEXPR_ENGINE symbolic::matrix model::get_for_code(const derivation::request& wanted) {
  const symbolic::matrix found =
      runtime::try_form(*system_, [&] { return runtime::form_result(*system_, wanted); });
  if (wanted.is_of_linearization()) system_->note_linearization(found);
  return found;
}

KANEXPR_ENGINE symbolic::matrix model::measured_by(std::span<const derivation::request> measured) {
  return runtime::try_form(*system_, [&] {
    derivation::visit(measured, system_->reader());
    symbolic::matrix all(graph(), 0, 1);
    for (const derivation::request& each : measured)
      for (const symbolic::expression& e :
           derivation::form_with_rates(each, system_->reader(), equations()).entries)
        all.entries.push(e);
    all.rows = all.entries.size();
    return all;
  });
}

KANEXPR_ENGINE mechanics::vector model::vector(const describe::phrase& words) {
  return runtime::try_form(*system_, [&] {
    system_->reader().visit(words.tokens, words.size);
    system_->reader().add_late_entities();
    const derivation::value found = system_->reader().evaluate(words, "an expression");
    if (found.kind != describe::shape::vector)
      system_->reader().fail("the expression requested as a vector is not a vector");
    return found.vector;
  });
}

KANEXPR_ENGINE symbolic::expression model::in_motion(symbolic::expression e) {
  return system_->mistake() ? e : equations().in_motion(e);
}

KANEXPR_ENGINE symbolic::expression model::imposed(symbolic::expression e) {
  return system_->mistake() ? e : equations().imposed(e);
}
KANEXPR_ENGINE mechanics::vector model::imposed(const mechanics::vector& v) {
  mechanics::vector out;
  for (const mechanics::vector::part& p : v.parts)
    out.add(p.frame, {imposed(p.value.x), imposed(p.value.y), imposed(p.value.z)});
  return out;
}

KANEXPR_ENGINE runtime::linearization model::linearize(const linearization_point& at,
                                                       const linearization_point& second,
                                                       const linearization_point& third) {
  return {system_, at.with(second).with(third)};
}

KANEXPR_ENGINE std::string model::print(const mechanics::vector& v, mechanics::basis_style style,
                                        std::size_t longest) const {
  return mechanics::print(mechanism(), v, style, longest);
}
KANEXPR_ENGINE std::string model::latex(const mechanics::vector& v, mechanics::basis_style style,
                                        std::size_t longest) const {
  return mechanics::latex(mechanism(), v, style, longest);
}

KANEXPR_ENGINE std::shared_ptr<const derivation::survey> model::known() const {
  auto found = std::make_shared<derivation::survey>();
  found->take(system_->system(), !system_->mistake(), system_->equations());
  found->states_units = system_->states_units();
  return found;
}

KANEXPR_ENGINE mechanics::possible_unit model::unit_of(const symbolic::expression& e) const {
  if (!e.belongs_to(system_->graph())) return std::nullopt;
  return system_->unit_of(e);
}

KANEXPR_ENGINE mechanics::possible_unit model::unit_of(const describe::phrase& p) const {
  return system_->unit_of(p);
}

KANEXPR_ENGINE bool model::owns(const symbolic::matrix& result) const {
  for (const symbolic::expression& e : result.entries)
    if (!e.belongs_to(system_->graph())) return false;
  return true;
}

KANEXPR_ENGINE mechanics::possible_unit model::unit_of(mechanics::quantity wanted, int row,
                                                       int column) const {
  return derivation::result_units(units(), *known()).of(wanted, row, column);
}

KANEXPR_ENGINE base::sentence model::mistake_of(const symbolic::matrix& result) const {
  if (system_->mistake()) return system_->mistake();
  if (!owns(result)) return base::sentence({"the result to be evaluated belongs to a different model"});
  if (result.rows != 0 || result.columns != 0) return {};
  return system_->request_mistake ? system_->request_mistake
                                  : base::sentence({"the result to be evaluated was not formed"});
}

KANEXPR_ENGINE int model::coordinates() const { return mechanism().coordinates.size(); }

KANEXPR_ENGINE base::sequence<mechanics::singularity_check>
model::singularity_checks_of(const symbolic::matrix& result) {
  if (system_->equations() == nullptr) return {};
  base::sequence<int> outputs;
  for (const symbolic::expression& e : result.entries) outputs.push(e.node());
  return equations().singularity_checks_of(outputs);
}

} // namespace kanexpr
