#pragma once

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

/// The closed loop of docs/guide/joints.md, with the symbols that the page takes for given.
namespace docs::loop {

using namespace kanexpr;

constexpr parameter<"l0"> l0;
constexpr parameter<"l1"> l1;
constexpr parameter<"l2"> l2;
constexpr parameter<"l3"> l3;
constexpr parameter<"d1"> d1;
constexpr parameter<"d2"> d2;
constexpr parameter<"d3"> d3;
constexpr parameter<"m1"> m1;
constexpr parameter<"m2"> m2;
constexpr parameter<"m3"> m3;
constexpr parameter<"I1"> I1;
constexpr parameter<"I2"> I2;
constexpr parameter<"I3"> I3;
constexpr parameter<"g"> g;

struct Ground : inertial_ground<Ground> {};

#include <docs/guide/joints/four_bar.cpp>

} // namespace docs::loop
