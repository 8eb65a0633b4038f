#pragma once

#include <kanexpr/numeric/sines_and_cosines.hpp>

/// What a careful person writes for two pendulums: the yardstick of the derived code. Arguments are plain
/// arrays in the order of the models' vectors. Sines and cosines are computed the same way.

[[gnu::always_inline]] inline void simple_pendulum_rhs_by_hand(const double* x, const double* p,
                                                               const double* r, double* rate) {
  const double q = x[0], u = x[1], m = p[0], l = p[1], g = p[2], c = p[3], T = r[0];
  double sine, cosine;
  kanexpr::numeric::sine_and_cosine(q, sine, cosine);
  rate[0] = u;
  rate[1] = (T - c * u - m * g * l * sine) / (m * l * l);
}

[[gnu::always_inline]] inline void double_pendulum_rhs_by_hand(const double* x, const double* p,
                                                               const double* r, double* rate) {
  const double q1 = x[0], q2 = x[1], u1 = x[2], u2 = x[3];
  const double m1 = p[0], m2 = p[1], d1 = p[2], d2 = p[3], l1 = p[4], I1 = p[5], I2 = p[6], g = p[7],
               c1 = p[8], c2 = p[9];
  const double T1 = r[0], T2 = r[1];
  const double angle[]{q1, q1 + q2};
  double sines[2], cosines[2];
  kanexpr::numeric::sines_and_cosines(angle, sines, cosines);
  const double s1 = sines[0], k1 = cosines[0], s12 = sines[1], k12 = cosines[1];
  const double m2d2 = m2 * d2, m2d2l1 = m2d2 * l1;
  const double cosine = k1 * k12 + s1 * s12, sine = s12 * k1 - k12 * s1; // of q2
  const double M11 = I1 + m1 * d1 * d1 + m2 * l1 * l1, M12 = m2d2l1 * cosine, M22 = I2 + m2d2 * d2;
  const double joint = T2 - c2 * (u2 - u1);
  const double f1 = T1 - c1 * u1 - joint - (m1 * d1 + m2 * l1) * g * k1 + m2d2l1 * sine * u2 * u2;
  const double f2 = joint - m2d2 * g * k12 - m2d2l1 * sine * u1 * u1;
  const double ratio = M12 / M22;
  rate[0] = u1;
  rate[1] = u2 - u1;
  rate[2] = (f1 - ratio * f2) / (M11 - ratio * M12);
  rate[3] = (f2 - M12 * rate[2]) / M22;
}
