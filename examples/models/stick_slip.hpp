#pragma once

#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>

/// A block with friction that a spring pulls, whose end moves with constant velocity.
namespace stick_slip {

using namespace kanexpr;
using namespace kanexpr::units::si;

constexpr parameter<"m", kilogram> m;
constexpr parameter<"k", newton / meter> k;
constexpr parameter<"l", meter> l;          // natural length of the spring
constexpr parameter<"V", meter / second> V; // velocity of its end
constexpr parameter<"Fs", newton> Fs;       // static friction
constexpr parameter<"Fc", newton> Fc;       // sliding friction
constexpr parameter<"vs", meter / second> vs;
constexpr parameter<"sigma0", newton / meter> sigma0;
constexpr parameter<"sigma1", newton * second / meter> sigma1;
constexpr parameter<"sigma2", newton * second / meter> sigma2;
constexpr time_variable t;

struct N : inertial_ground<N> {}; // x to the right, z up
struct Block : prismatic<Block, N, axis<N::x>, body<m, 0.0 * own::x>> {};
struct Hand : offset<Hand, N, (l + V * t) * N::x> {};

constexpr auto x = q_of<Block>;
constexpr auto v = u_of<Block>;
constexpr auto bristle = bristle_of<Block>;

struct System
    : kane_system<inertial<N>, parameters<m, k, l, V, Fs, Fc, vs, sigma0, sigma1, sigma2>, joints<Block>,
                  loads<linear_spring<straight<Block, Hand>, k, l>,
                        friction<Block, 1, lugre_friction<Fs, Fc, vs, sigma0, sigma1, sigma2>>>> {};

} // namespace stick_slip
