// Andrews' squeezing mechanism as published: M q'' = f - G^T lambda, g(q) = 0. Hairer & Wanner, Solving
// Ordinary Differential Equations II, section VII.7; Lioen & de Swart, Test Set for Initial Value Problem
// Solvers.
#pragma once

#include "systems/jet.hpp"

#include <Eigen/LU>

#include <array>
#include <type_traits>

namespace andrews_reference {

using vector7 = Eigen::Matrix<double, 7, 1>;
using vector6 = Eigen::Matrix<double, 6, 1>;

inline constexpr double m1 = .04325, m2 = .00365, m3 = .02373, m4 = .00706, m5 = .07050, m6 = .00706,
                        m7 = .05498;
inline constexpr double i1 = 2.194e-6, i2 = 4.410e-7, i3 = 5.255e-6, i4 = 5.667e-7, i5 = 1.169e-5,
                        i6 = 5.667e-7, i7 = 1.912e-5;
inline constexpr double xa = -.06934, ya = -.00227, xb = -.03635, yb = .03273, xc = .014, yc = .072;
inline constexpr double d = 28e-3, da = 115e-4, e = 2e-2, ea = 1421e-5, rr = 7e-3, ra = 92e-5, ss = 35e-3,
                        sa = 1874e-5, sb = 1043e-5, sc = 18e-3, sd = 2e-2, ta = 2308e-5, tb = 916e-5,
                        u = 4e-2, ua = 1228e-5, ub = 449e-5, zf = 2e-2, zt = 4e-2, fa = 1421e-5;
inline constexpr double c0 = 4530, l0 = 7785e-5, mom = 33e-3;

// beta, Theta, gamma, Phi, delta, Omega, epsilon
inline const vector7 start{{-0.0617138900142764496358948458001, 0, 0.455279819163070380255912382449,
                            0.222668390165885884674473185609, 0.487364979543842550225598953530,
                            -0.222668390165885884674473185609, 1.23054744454982119249735015568}};
inline const vector7 start_acceleration{
    {14222.4439199541138705911625887, -10666.8329399655854029433719415, 0, 0, 0, 0, 0}};
inline const vector6 start_multipliers{
    {98.5668703962410896057654982170, -6.12268834425566265503114393122, 0, 0, 0, 0}};

template <class Angles>
auto loops(const Angles& q) {
  using number = std::decay_t<decltype(q[0])>;
  using std::cos, std::sin;
  const number &be = q[0], &th = q[1], &ga = q[2], &ph = q[3], &de = q[4], &om = q[5], &ep = q[6];
  return std::array<number, 6>{rr * cos(be) - d * cos(be + th) - ss * sin(ga) - number(xb),
                               rr * sin(be) - d * sin(be + th) + ss * cos(ga) - number(yb),
                               rr * cos(be) - d * cos(be + th) - e * sin(ph + de) - zt * cos(de) - number(xa),
                               rr * sin(be) - d * sin(be + th) + e * cos(ph + de) - zt * sin(de) - number(ya),
                               rr * cos(be) - d * cos(be + th) - zf * cos(om + ep) - u * sin(ep) - number(xa),
                               rr * sin(be) - d * sin(be + th) - zf * sin(om + ep) + u * cos(ep) -
                                   number(ya)};
}

inline vector6 gap(const vector7& q) { return vector6(loops(q).data()); }

inline Eigen::Matrix<double, 7, 7> mass_matrix(const vector7& q) {
  const double th = q(1), ph = q(3), om = q(5);
  Eigen::Matrix<double, 7, 7> m = Eigen::Matrix<double, 7, 7>::Zero();
  m(0, 0) = m1 * ra * ra + m2 * (rr * rr - 2 * da * rr * std::cos(th) + da * da) + i1 + i2;
  m(1, 0) = m(0, 1) = m2 * (da * da - da * rr * std::cos(th)) + i2;
  m(1, 1) = m2 * da * da + i2;
  m(2, 2) = m3 * (sa * sa + sb * sb) + i3;
  m(3, 3) = m4 * (e - ea) * (e - ea) + i4;
  m(4, 3) = m(3, 4) = m4 * ((e - ea) * (e - ea) + zt * (e - ea) * std::sin(ph)) + i4;
  m(4, 4) = m4 * (zt * zt + 2 * zt * (e - ea) * std::sin(ph) + (e - ea) * (e - ea)) +
            m5 * (ta * ta + tb * tb) + i4 + i5;
  m(5, 5) = m6 * (zf - fa) * (zf - fa) + i6;
  m(6, 5) = m(5, 6) = m6 * ((zf - fa) * (zf - fa) - u * (zf - fa) * std::sin(om)) + i6;
  m(6, 6) = m6 * ((zf - fa) * (zf - fa) - 2 * u * (zf - fa) * std::sin(om) + u * u) +
            m7 * (ua * ua + ub * ub) + i6 + i7;
  return m;
}

inline vector7 force(const vector7& q, const vector7& v) {
  const double th = q(1), ga = q(2), ph = q(3), om = q(5);
  const double bep = v(0), thp = v(1), php = v(3), dep = v(4), omp = v(5), epp = v(6);
  const double xd = sd * std::cos(ga) + sc * std::sin(ga) + xb,
               yd = sd * std::sin(ga) - sc * std::cos(ga) + yb;
  const double length = std::sqrt((xd - xc) * (xd - xc) + (yd - yc) * (yd - yc));
  const double pull = -c0 * (length - l0) / length, fx = pull * (xd - xc), fy = pull * (yd - yc);
  return vector7{{mom - m2 * da * rr * thp * (thp + 2 * bep) * std::sin(th),
                  m2 * da * rr * bep * bep * std::sin(th),
                  fx * (sc * std::cos(ga) - sd * std::sin(ga)) + fy * (sd * std::cos(ga) + sc * std::sin(ga)),
                  m4 * zt * (e - ea) * dep * dep * std::cos(ph),
                  -m4 * zt * (e - ea) * php * (php + 2 * dep) * std::cos(ph),
                  -m6 * u * (zf - fa) * epp * epp * std::cos(om),
                  m6 * u * (zf - fa) * omp * (omp + 2 * epp) * std::cos(om)}};
}

inline Eigen::Matrix<double, 6, 7> jacobian(const vector7& q) {
  const double be = q(0), th = q(1), ga = q(2), ph = q(3), de = q(4), om = q(5), ep = q(6);
  Eigen::Matrix<double, 6, 7> G = Eigen::Matrix<double, 6, 7>::Zero();
  for (int loop = 0; loop < 6; loop += 2) {
    G(loop, 0) = -rr * std::sin(be) + d * std::sin(be + th);
    G(loop, 1) = d * std::sin(be + th);
    G(loop + 1, 0) = rr * std::cos(be) - d * std::cos(be + th);
    G(loop + 1, 1) = -d * std::cos(be + th);
  }
  G(0, 2) = -ss * std::cos(ga);
  G(1, 2) = -ss * std::sin(ga);
  G(2, 3) = -e * std::cos(ph + de);
  G(2, 4) = -e * std::cos(ph + de) + zt * std::sin(de);
  G(3, 3) = -e * std::sin(ph + de);
  G(3, 4) = -e * std::sin(ph + de) - zt * std::cos(de);
  G(4, 5) = zf * std::sin(om + ep);
  G(4, 6) = zf * std::sin(om + ep) - u * std::cos(ep);
  G(5, 5) = -zf * std::cos(om + ep);
  G(5, 6) = -zf * std::cos(om + ep) - u * std::sin(ep);
  return G;
}

// The second derivatives of the loop constraints at zero accelerations.
inline vector6 curvature(const vector7& q, const vector7& v) {
  std::array<hand_written::jet, 7> along;
  for (int i = 0; i < 7; ++i) along[static_cast<std::size_t>(i)] = {q(i), v(i), 0};
  const auto all = loops(along);
  vector6 second;
  for (int i = 0; i < 6; ++i) second(i) = all[static_cast<std::size_t>(i)].second;
  return second;
}

struct solution {
  vector7 acceleration;
  vector6 multipliers;
};

inline solution solve(const vector7& q, const vector7& v) {
  using matrix = Eigen::Matrix<double, 13, 13>;
  using vector = Eigen::Matrix<double, 13, 1>;
  // Multipliers in N and accelerations in rad/s^2 are larger than inertias in kg m^2 by this factor.
  const double scale = 1e-4;
  matrix all = matrix::Zero();
  all.topLeftCorner<7, 7>() = mass_matrix(q) / scale;
  all.topRightCorner<7, 6>() = jacobian(q).transpose();
  all.bottomLeftCorner<6, 7>() = jacobian(q);
  vector right;
  right << force(q, v), -scale * curvature(q, v);
  const Eigen::FullPivLU<matrix> factors(all);
  vector found = factors.solve(right);
  found += factors.solve(right - all * found);
  return {found.head<7>() / scale, found.tail<6>()};
}

// Moves q to a configuration that satisfies the constraints.
inline bool close(vector7& q) {
  for (int step = 0; step < 30; ++step) {
    const Eigen::Matrix<double, 6, 7> G = jacobian(q);
    const vector7 change = G.transpose() * (G * G.transpose()).fullPivLu().solve(gap(q));
    q -= change;
    if (change.norm() < 1e-15) break;
  }
  return gap(q).norm() < 1e-16;
}

// The part of these rates that the loops permit.
inline vector7 allowed(const vector7& q, vector7 rates) {
  const Eigen::Matrix<double, 6, 7> G = jacobian(q);
  for (int step = 0; step < 3; ++step)
    rates -= G.transpose() * (G * G.transpose()).fullPivLu().solve(G * rates);
  return rates;
}

} // namespace andrews_reference
