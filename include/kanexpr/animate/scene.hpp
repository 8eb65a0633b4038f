#pragma once

#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/compiled_pages.hpp>
#include <kanexpr/animate/picture.hpp>
#include <kanexpr/compiled/code_table.hpp>
#include <kanexpr/compiled/survey_of.hpp>
#include <kanexpr/compiled/units_of.hpp>
#include <kanexpr/derivation/model_units.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/describe/beam_record.hpp>
#include <kanexpr/describe/flexible_record.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/record.hpp>
#include <kanexpr/mechanics/units/unit_table.hpp>
#include <kanexpr/units/unit_text.hpp>

#include <array>
#include <span>
#include <string_view>

namespace kanexpr::animate {

/// An element of a picture as a plain value.
struct element_record {
  std::string_view word{};
  base::name name{};          ///< "sphere at P"
  std::string_view shape{};   ///< "sphere"; empty if it shows no shape
  std::string_view profile{}; ///< the cross section of a sweep
  std::string_view file{};    ///< mesh file, or the folder for files_in
  look looks{};
  placement_kind placed_by = placement_kind::place;
  bool has_axis = false; ///< if true, the shape's axis precedes the frame's axes
  std::size_t places = 1;
  const describe::path_record* path = nullptr; ///< which a cable follows
  int first_varying = 0;                       ///< index of its first number among all numbers
  int first_constant = 0;
  int constant = 0;
  std::string_view unit{};           ///< the unit of what it plots
  std::span<const phrase> symbols{}; ///< the symbols to which it gives the unit
  const phrase* quantity = nullptr;  ///< the vector of an arrow or the scalar of a plot
  base::name unit_of_model{};        ///< the unit of this quantity, if the model determines it
  int first_rate = 0;                ///< index among the rates
  int rates = 0;
};

template <class Element>
constexpr element_record record_of_element() {
  element_record r;
  r.word = Element::word;
  r.constant = numbers_in(Element::constant);
  r.rates = numbers_in(Element::rates);
  if constexpr (shape_element<Element>) {
    using attachment = typename Element::attachment;
    r.name = title_of<Element>();
    r.shape = kind_of<Element>();
    r.looks = Element::look;
    r.placed_by = attachment::placed_by;
    r.has_axis = requires { attachment::axis; };
    if constexpr (requires { attachment::file; }) r.file = attachment::file;
    if constexpr (requires { attachment::profile; }) r.profile = attachment::profile;
    if constexpr (requires { attachment::path; }) r.path = &attachment::path;
    if constexpr (requires { attachment::places; }) {
      r.places = attachment::places;
      r.has_axis = r.placed_by == placement_kind::pose;
    }
    if (r.shape == "arrow") r.quantity = &Element::varying.back();
  }
  if constexpr (Element::word == "plot") r.quantity = &Element::varying.front();
  if constexpr (requires { Element::folder; }) r.file = Element::folder;
  if constexpr (requires { Element::unit; }) r.unit = Element::unit;
  if constexpr (requires { Element::symbols; }) r.symbols = Element::symbols;
  if constexpr (requires { Element::name; }) r.looks.name = Element::name;
  return r;
}

/// The elements of a picture, and the units of its model if it was read for the units of arrows and plots.
template <std::size_t count>
struct element_records {
  std::array<element_record, count> list{};
  mechanics::unit_table units{};
};

/// Infers the units of arrows and plots, if the model states any units.
template <class System, std::size_t count>
constexpr void infer_units(element_records<count>& all) {
  if constexpr (compiled::survey_of<System>.states_units) {
    derivation::model_units model(System::record);
    if (compiled::survey_of<System>.checks_units) all.units = model.table();
    for (element_record& r : all.list) {
      if (r.quantity == nullptr) continue;
      if (const mechanics::possible_unit found = model.unit_of(*r.quantity))
        r.unit_of_model = units::text_of(*found);
    }
  }
}

template <class System, class Elements>
struct records_in;
template <class Picture>
struct records_of;

template <class System, class... Elements>
struct records_of<picture<System, Elements...>> : records_in<System, elements_of<System, Elements...>> {};

template <class System, class... Elements>
struct records_in<System, element_list<Elements...>> {
  static constexpr element_records<sizeof...(Elements)> all = [] {
    using numbers = numbers_in_list<element_list<Elements...>>;
    element_records<sizeof...(Elements)> made{{record_of_element<Elements>()...}};
    for (std::size_t i = 0; i < made.list.size(); ++i) {
      made.list[i].first_varying = numbers::varying.begin[i];
      made.list[i].first_constant = numbers::first_constant + numbers::constant.begin[i];
      made.list[i].first_rate = numbers::rates.begin[i];
    }
    infer_units<System>(made);
    return made;
  }();

  /// The units of the model; null if it states none.
  static constexpr const mechanics::unit_table* units() {
    if constexpr (compiled::survey_of<System>.checks_units) // the same as those of the system, read only once
      return &all.units;
    else
      return compiled::stated_units_of<System>();
  }
};

/// The number of amplitudes of beams and other flexible bodies.
constexpr int amplitudes_in(const describe::listing<describe::body_record>& bodies) {
  int count = 0;
  for (const describe::body_record& r : bodies) {
    if (r.beam != nullptr) count += r.beam->coordinates.size;
    if (r.flexible != nullptr) count += r.flexible->coordinates.size;
  }
  return count;
}

/// An interface, independent of the system type, to a motion and to the numbers of its picture.
class scene {
public:
  virtual ~scene() = default;
  scene(const scene&) = delete;
  scene& operator=(const scene&) = delete;

  const derivation::survey& known;
  const mechanics::unit_table* units; ///< null if the model states none
  std::span<const element_record> elements;
  const compiled::code_table& table; ///< evaluates all numbers of the picture
  int numbers, first_rate, rates; ///< their count, and the range of those that are integrated; the energies
                                  ///< follow these if the picture plots them
  int amplitudes; ///< the number of amplitudes of flexible bodies, which are the last coordinates

  virtual std::size_t samples() const = 0;
  virtual void parameters(double* p) const = 0;
  /// Returns the time, the state and the inputs of a sample.
  virtual void sample(std::size_t which, double& t, double* x, double* r) const = 0;
  /// Returns the state and the inputs at any other time; false if the motion does not provide them.
  virtual bool between(double t, double* x, double* r) const = 0;

protected:
  scene(const derivation::survey& of, const mechanics::unit_table* units_of_symbols,
        std::span<const element_record> shown, const compiled::code_table& code, int all, int first,
        int integrated, int deforming)
      : known(of), units(units_of_symbols), elements(shown), table(code), numbers(all), first_rate(first),
        rates(integrated), amplitudes(deforming) {}
};

KANEXPR_PAGES animation film(const scene& shown);

} // namespace kanexpr::animate
