#pragma once

#include <kanexpr/base/members.hpp>
#include <kanexpr/base/name.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/mechanics/loads/force_system.hpp>
#include <kanexpr/mechanics/loads/load_check.hpp>
#include <kanexpr/mechanics/loads/load_units.hpp>
#include <kanexpr/mechanics/loads/state_rate.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <type_traits>

namespace kanexpr::mechanics {

struct element;

/// The functions of a kind of loads; a kind without state variables or without an energy lacks the second or
/// the third.
struct element_kind {
  void (*act)(const element&, force_system&, conservative) = nullptr;
  void (*add_state_rates)(const element&, force_system&, sequence<state_rate>&) = nullptr;
  expression (*potential_energy)(const element&, const mechanism&) = nullptr;
  void (*check_with)(const element&, load_check&, int) = nullptr;
  void (*state_units)(const element&, load_units&, int) = nullptr;
};

/// A load whose kind only its own header knows, such as a contact or a muscle. Everything else that handles
/// loads sees its expressions and integers, so a model pays only for the kinds that it contains.
struct element {
  const element_kind* kind = nullptr;
  sequence<expression> expressions{};
  sequence<int> integers{};

  constexpr void act(force_system& on, conservative how) const { kind->act(*this, on, how); }
  constexpr void add_state_rates(force_system& on, sequence<state_rate>& all) const {
    if (kind->add_state_rates != nullptr) kind->add_state_rates(*this, on, all);
  }
  constexpr expression potential_energy(const mechanism& m) const {
    return kind->potential_energy != nullptr ? kind->potential_energy(*this, m) : m.zero();
  }
  constexpr void check_with(load_check& by, int place) const { kind->check_with(*this, by, place); }
  constexpr void state_units(load_units& by, int place) const { kind->state_units(*this, by, place); }
};

namespace detail {

/// Takes a load apart into the expressions and integers of an element, or puts it together from them.
class element_transfer {
  // clang++ requires its definition before its use in constant expressions.
  template <class Integer>
  constexpr void integer(Integer& i) {
    if (into_ != nullptr)
      into_->integers.push(static_cast<int>(i));
    else
      i = static_cast<Integer>(from_->integers[next_integer_++]);
  }

public:
  constexpr explicit element_transfer(element& into) : into_(&into) {}
  constexpr explicit element_transfer(const element* from) : from_(from) {}

  template <class... Parts>
    requires(sizeof...(Parts) > 1)
  constexpr void operator()(Parts&... parts) {
    ((*this)(parts), ...);
  }
  template <class Part>
  constexpr void operator()(Part& part) {
    if constexpr (std::is_integral_v<Part> || std::is_enum_v<Part>)
      integer(part);
    else
      for_each_member(part, *this);
  }
  template <class Part>
  constexpr void operator()(sequence<Part>& parts) {
    int size = parts.size();
    integer(size);
    if (into_ == nullptr) parts.resize(size);
    for (Part& each : parts) (*this)(each);
  }
  constexpr void operator()(expression& e) {
    if (into_ != nullptr)
      into_->expressions.push(e);
    else
      e = from_->expressions[next_expression_++];
  }
  constexpr void operator()(base::name& called) {
    integer(called.length);
    for (int i = 0; i < called.length; ++i) integer(called.letters[i]);
  }

private:
  element* into_ = nullptr; ///< null if it puts a load together
  const element* from_ = nullptr;
  int next_expression_ = 0, next_integer_ = 0;
};

} // namespace detail

/// The load that an element contains, which must be of this kind.
template <class Load>
constexpr Load load_in(const element& e) {
  Load load;
  detail::element_transfer transfer(&e);
  transfer(load);
  return load;
}

namespace detail {

template <class Load>
constexpr void act(const element& e, force_system& on, conservative how) {
  load_in<Load>(e).act(on, how);
}
template <class Load>
constexpr void add_state_rates(const element& e, force_system& on, sequence<state_rate>& all) {
  load_in<Load>(e).add_state_rates(on, all);
}
template <class Load>
constexpr expression potential_energy(const element& e, const mechanism& m) {
  return load_in<Load>(e).potential_energy(m);
}
template <class Load>
constexpr void check_with(const element& e, load_check& by, int place) {
  load_in<Load>(e).check_with(by, place);
}
template <class Load>
constexpr void state_units(const element& e, load_units& by, int place) {
  load_in<Load>(e).state_units(by, place);
}

template <class Load>
consteval element_kind kind_of_load() {
  element_kind kind{act<Load>, nullptr, nullptr, check_with<Load>, state_units<Load>};
  if constexpr (requires { &Load::add_state_rates; }) kind.add_state_rates = add_state_rates<Load>;
  if constexpr (requires { &Load::potential_energy; }) kind.potential_energy = potential_energy<Load>;
  return kind;
}

} // namespace detail

/// The kind of the loads of a type.
template <class Load>
inline constexpr element_kind element_kind_of = detail::kind_of_load<Load>();

template <class Load>
constexpr element element_of(Load load) {
  element e{&element_kind_of<Load>, {}, {}};
  detail::element_transfer transfer(e);
  transfer(load);
  return e;
}

} // namespace kanexpr::mechanics
