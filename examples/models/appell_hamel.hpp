#pragma once

#include <kanexpr/kanexpr.hpp>

/// Appell and Hamel's example of a constraint that is not linear in the speeds: a particle whose horizontal
/// speed is a times its vertical speed. Thin wheels, pulleys and a thread produce it in the limit of a small
/// radius. Appell, Comptes Rendus 152 (1911); Hamel, Theoretische Mechanik (1949).
namespace appell_hamel {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr coordinate<"x", meter> x;
constexpr coordinate<"y", meter> y;
constexpr coordinate<"z", meter> z;
constexpr speed<"u"> u;
constexpr speed<"v"> v;
constexpr speed<"w"> w;
constexpr parameter<"m", kilogram> m;
constexpr parameter<"a", dimensionless> a; // the horizontal speed divided by the vertical one
constexpr parameter<"g", meter / pow<2>(second)> g;
constexpr input<"F", newton> F; // a horizontal force

struct N : inertial_frame<N> {};
struct O : origin<O, N> {};
struct P : offset<P, O, x * N::x + y * N::y + z * N::z> {};
struct Weight : particle<Weight, P, m> {};

struct System : kane_system<inertial<N>, coordinates<x, y, z>, speeds<u, v, w>,
                            kinematics<dot(x) == u, dot(y) == v, dot(z) == w>,
                            velocity_constraints<u * u + v * v == a * a * w * w>, dependent<w>, inputs<F>,
                            bodies<Weight>, loads<gravity<-g * N::z>, force<P, F * N::x>>> {};

} // namespace appell_hamel
