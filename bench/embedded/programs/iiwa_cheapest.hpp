#pragma once

#include "iiwa.hpp"
#include "udot.hpp"

/// u̇ of the iiwa by the form of the equations that `explain` found to be the cheapest.
namespace embedded::iiwa {

struct Cheapest
    : kanexpr::extended<System,
                        kanexpr::formulation<kanexpr::written_in<Link7, Link6>, kanexpr::by_elimination>> {};
struct cheapest_calls : calls {
  using system = Cheapest;
};

} // namespace embedded::iiwa

struct program : embedded::udot_of<embedded::iiwa::cheapest_calls> {};
