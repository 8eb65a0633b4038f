// A mechanism as plain numbers, from which both the library's model and an independent evaluation are built.
#pragma once

#include <Eigen/Core>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace recipe {

// A number, or a symbolic parameter with that value.
struct constant {
  double value = 0;
  int parameter = -1;
};

enum class kind { coordinate, sine, cosine_times_rate, rate, speed, input, time };

struct term {
  constant factor;
  kind what{};
  int index = 0;
};

// base + Σ factor · (q, sin q, cos q q̇, q̇, u, r or t)
struct formula {
  constant base;
  std::vector<term> terms;
};

using triple = std::array<formula, 3>;

struct part {
  int frame = 0;
  triple value;
};

using sum = std::vector<part>; // a vector as a sum over frames

enum class turn { ground, about_basis, about_axis, body_fixed, space_fixed, cosines, quaternion };

struct frame {
  turn how = turn::ground;
  int parent = -1;
  int axis = 0;
  bool backwards = false;            // about the negative basis vector
  std::array<constant, 3> direction; // of any length
  std::string letters;
  std::array<formula, 3> angle; // the direction cosines of a body-fixed sequence
  int quaternion = 0;           // its first coordinate
  int reference = -1;           // of a declared angular velocity
  sum angular_velocity;
  bool turns_apart = false; // the angular velocity need not match the orientation
};

struct point {
  int parent = -1; // -1: an origin
  sum offset;
  int fixed_in = -1;
  int reference = -1; // of a declared velocity
  sum velocity;
  bool moves_apart = false; // the velocity need not match the position
};

struct inertia {
  int axes = 0;
  std::array<constant, 6> scalars; // xx yy zz xy yz zx
};

struct body {
  int center = 0;
  int frame = -1; // -1: a particle
  constant mass;
  std::vector<inertia> dyadic;
  int about = -1;
  bool inertia_changes = false; // as seen from the body
};

struct load {
  int on = 0; // a point or a frame
  sum value;
  int against = -1; // the one on which the opposite load acts
};

struct spring {
  int point = 0, other = 0;
  constant stiffness, length, damping;
};

struct damper {
  int frame = 0, against = 0;
  constant damping;
};

struct twist { // of a torsional spring
  formula angle;
  constant stiffness, rest;
};

// The relation between q̇ and u.
enum class law {
  linear,              // A q̇ + b = u
  body_rates,          // u: the angular velocity of a body-fixed sequence in the frame's axes
  quaternion,          // ė = ½ E u
  implicit_quaternion, // u = 2 Eᵀ ė, e·ė = 0
  base_velocity,       // q̇ = R u, where R is the matrix of a frame
};

struct rates {
  law how = law::linear;
  std::vector<int> coordinates, speeds;
  std::vector<formula> matrix, offset;
  int frame = 0;
};

struct mechanism {
  std::vector<frame> frames{frame{}};
  std::vector<point> points{point{}};
  std::vector<body> bodies;
  std::vector<load> forces, torques;
  std::vector<spring> springs;
  std::vector<damper> dampers;
  std::vector<twist> twists;
  bool has_gravity = false;
  std::array<constant, 3> gravity; // ground axes
  std::vector<rates> kinematics;
  std::vector<double> q, u, r, parameters; // the state to examine
  double t = 0;
};

// The values on which formulas depend, in some scalar type.
template <class T>
struct values {
  std::vector<T> q, qdot, u, r, parameters;
  T t;
  std::function<T(double)> number;

  T operator()(const constant& c) const {
    return c.parameter < 0 ? number(c.value) : parameters[static_cast<std::size_t>(c.parameter)];
  }
  T operator()(const formula& f) const {
    T total = (*this)(f.base);
    for (const term& one : f.terms) total += (*this)(one.factor) * (*this)(one);
    return total;
  }
  T operator()(const term& one) const {
    const auto i = static_cast<std::size_t>(one.index);
    switch (one.what) {
    case kind::coordinate: return q[i];
    case kind::sine: return sin(q[i]);
    case kind::cosine_times_rate: return cos(q[i]) * qdot[i];
    case kind::rate: return qdot[i];
    case kind::speed: return u[i];
    case kind::input: return r[i];
    case kind::time: return t;
    }
    return t;
  }
};

} // namespace recipe
