#pragma once

#include "pendulum.hpp"

// Systems for files with many mistakes, each of which has a separate namespace.

template <class... Words>
using told =
    kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>, Words...>;

template <class... Loads>
using loaded = told<loads<Loads...>>;

template <auto... equations>
using moved_by = kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<equations...>, bodies<Bob>>;

template <auto... constraints>
using bound_by = bound_pendulum<velocity_constraints<constraints...>>;

constexpr parameter<"k"> k;
constexpr parameter<"c"> c;
constexpr input<"F"> F;

struct Q : offset<Q, O, l * N::y> {};
