// builds: clang++ sanitize
#include <kanexpr/batch.hpp>
#include <kanexpr/kanexpr.hpp>
#include <models/double_pendulum.hpp>

#include <gtest/gtest.h>

#include <cstdint>

namespace {

using namespace kanexpr;
using namespace double_pendulum;
using eom = equations_of_motion<System>;

TEST(many, has_a_row_for_each_entry) {
  many<eom::state> x(1000);
  x[q2] = 0.25;
  x[u1] = Eigen::ArrayXd::LinSpaced(1000, 0, 999).transpose();
  x[u1](3) = -1;
  const many<eom::state>& seen = x;
  EXPECT_EQ(seen.size(), 1000);
  EXPECT_EQ(seen[q2].size(), 1000);
  EXPECT_EQ(seen[q1].sum(), 0);
  EXPECT_EQ(seen[q2].sum(), 250);
  EXPECT_EQ(seen(1).sum(), 250);
  EXPECT_EQ(seen[u1](999), 999);
  EXPECT_EQ(seen.data()[2 * seen.stride() + 999], 999);
}

TEST(many, gives_and_takes_single_systems) {
  many<eom::state> x(3);
  x.set(1, {{q1, 1}, {q2, 2}, {u1, 3}, {u2, 4}});
  EXPECT_EQ(x.get(0), eom::state());
  EXPECT_EQ(x.get(1), Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_EQ(x[q2].matrix(), Eigen::RowVector3d(0, 2, 0));
  const many<eom::state> copy = x;
  x[q2] = 7;
  EXPECT_EQ(copy.get(1), Eigen::Vector4d(1, 2, 3, 4));
}

TEST(many, is_made_as_one_is) {
  many<eom::parameters> p(2);
  p[m1] = 1;
  EXPECT_EQ(p.get(1).mistake().cause(), "parameter m2 has no value");
  const many<eom::inputs> r(5, {{T1, 1}, {T2, 2}});
  EXPECT_EQ(r.get(4), Eigen::Vector2d(1, 2));
  EXPECT_EQ(many<Eigen::Matrix2d>(4).get(3), Eigen::Matrix2d::Zero());
  EXPECT_EQ(many<eom::state>(0).size(), 0);
  EXPECT_EQ(many<eom::state>(-3).size(), 0);
  EXPECT_EQ((many_results<function<System, mechanics::quantity::qdot>>(-3).size()), 0);
  rollout<runge_kutta_4<System>> none(-3, {.step = 0.1, .steps = 5, .store_every = 1});
  many<eom::state> x(-3);
  EXPECT_EQ(none.size(), 0);
  EXPECT_TRUE(none.run(x, eom::parameters::Ones(), eom::inputs::Zero()));
}

TEST(many, has_no_systems_once_it_is_moved_from) {
  many<eom::state> x(9);
  x[q2] = 3;
  const many<eom::state> taken = std::move(x);
  EXPECT_EQ(taken.get(8)[q2], 3);
  EXPECT_EQ(x.size(), 0); // NOLINT(bugprone-use-after-move): what it promises
  x = many<eom::state>(2);
  EXPECT_EQ(x.size(), 2);
}

TEST(many, begins_rows_on_cache_lines_at_odd_distances) {
  for (const int count : {1, 8, 100, 512, 1024}) {
    const many<state<System, float>> x(count);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(x.data()) % 64, 0);
    EXPECT_EQ(static_cast<std::size_t>(x.stride()) * sizeof(float) % 128, 64);
    EXPECT_GE(x.stride(), count);
  }
}

TEST(many, has_matrices_by_rows_and_columns) {
  many<Eigen::Matrix<double, 2, 3>> m(4);
  m(1, 2) = 5;
  m(0, 1)(3) = 6;
  EXPECT_EQ(m.get(0), (Eigen::Matrix<double, 2, 3>() << 0, 0, 0, 0, 0, 5).finished());
  EXPECT_EQ(m.get(3), (Eigen::Matrix<double, 2, 3>() << 0, 6, 0, 0, 0, 5).finished());
}

} // namespace
