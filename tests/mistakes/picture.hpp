#pragma once

#include "pendulum.hpp"

#include <kanexpr/animate/animated.hpp>

// The pendulum with one of its trajectories, for pictures.

struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                            loads<weight, torque<A, T * N::z>>> {};

struct Samples {
  struct sample {
    double t;
    state<System> x;
    input_values<System> r;
  };
  std::vector<sample> all;
  auto begin() const { return all.begin(); }
  auto end() const { return all.end(); }
  parameter_values<System> parameters() const { return {}; }
};

template <class... Words>
bool draw() {
  return static_cast<bool>(animated<picture<System, Words...>>(Samples{}));
}
