// builds: clang++
// Frames and points that occur only in an expression can be added to an existing derivation without changing
// its results.
#include <kanexpr/derivation/extract_code.hpp>
#include <kanexpr/symbolic.hpp>
#include <models/bicycle.hpp>
#include <models/rolling_disc.hpp>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>

namespace {

using kanexpr::derivation::derived_system;
using kanexpr::derivation::request;
using kanexpr::derivation::requested;
using kanexpr::derivation::stage;
using kanexpr::mechanics::quantity;

namespace camera {

using namespace bicycle;

// rotates twice as far as the steering, pitches with the lean, and slides on the handlebar
struct Pan : rotated<Pan, Fork, 2 * q5, Fork::x> {};
struct Tilt : rotated<Tilt, Pan, 0.3 + q2, Pan::y> {};
struct Mount : offset<Mount, Steer, forkoffset * Fork::x + 0.1 * q5 * Fork::y> {};
struct Lens : offset<Lens, Mount, 0.05 * Tilt::z> {};
struct Reflector : offset<Reflector, WF_mc, 0.2 * WF::x>, fixed_in<WF> {};

constexpr auto of_lens = velocity_of<Lens>;
constexpr auto of_lens_by_parts = velocity_of<Steer> + derivative_in<N>(position_of<Lens, Steer>);
constexpr auto of_reflector = velocity_of<Reflector>;
constexpr auto of_reflector_by_parts =
    velocity_of<WF_mc> + cross(angular_velocity_of<WF>, position_of<Reflector, WF_mc>);
constexpr auto rate_of_lens = acceleration_of<Lens>;
constexpr auto rate_of_lens_by_parts = derivative_in<N>(velocity_of<Lens>);
constexpr auto rate_of_tilt = angular_acceleration_of<Tilt>;
constexpr auto rate_of_tilt_by_parts = derivative_in<N>(angular_velocity_of<Tilt>);

} // namespace camera

constexpr quantity all_results[]{quantity::mass_matrix,
                                 quantity::forcing,
                                 quantity::udot,
                                 quantity::kinetic_energy,
                                 quantity::potential_energy,
                                 quantity::angular_momentum,
                                 quantity::velocity_residual,
                                 quantity::constraint_jacobian,
                                 quantity::state_matrix,
                                 quantity::input_matrix};

kanexpr::lower::tape tape_for(derived_system& system, quantity wanted) {
  const request all[]{{.what = request::kind::result, .wanted = wanted}};
  return kanexpr::lower::tape_of(system.graph(), kanexpr::derivation::nodes_for(system, all).nodes);
}

template <auto a, auto b>
void expect_same_vector() {
  kanexpr::model derived = kanexpr::derive<bicycle::BoundSystem>();
  auto first = derived.function(derived.get<a>()), second = derived.function(derived.get<b>());
  ASSERT_EQ(derived.mistake(), "");
  std::srand(7);
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd x = Eigen::VectorXd::Random(10);
    const Eigen::VectorXd left = first(x), right = second(x);
    ASSERT_EQ(left.size(), 3);
    EXPECT_LT((left - right).norm(), 1e-12 * (1 + right.norm())) << x.transpose();
  }
}

} // namespace

TEST(late_entities, move_as_their_definitions_say) {
  using namespace camera;
  expect_same_vector<of_lens, of_lens_by_parts>();
  expect_same_vector<of_reflector, of_reflector_by_parts>();
  expect_same_vector<rate_of_lens, rate_of_lens_by_parts>();
  expect_same_vector<rate_of_tilt, rate_of_tilt_by_parts>();
}

TEST(late_entities, change_no_result) {
  for (const stage first : {stage::constrained, stage::equations, stage::linearized}) {
    derived_system plain(bicycle::System::record), extended(bicycle::System::record);
    for (derived_system* each : {&plain, &extended})
      for (int s = 0; s <= static_cast<int>(first); ++s)
        kanexpr::derivation::advance(*each, static_cast<stage>(s));
    constexpr request more = requested<camera::of_lens>::value;
    kanexpr::derivation::visit({&more, 1}, extended.reader());
    kanexpr::derivation::form(more, extended.reader(), extended.equations());
    ASSERT_FALSE(extended.mistake()) << extended.mistake().view();
    ASSERT_GT(extended.mechanism().points.size(), plain.mechanism().points.size());
    for (const quantity wanted : all_results) {
      const kanexpr::lower::tape a = tape_for(plain, wanted), b = tape_for(extended, wanted);
      ASSERT_EQ(a.steps.size(), b.steps.size()) << static_cast<int>(wanted);
      EXPECT_TRUE(
          std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(),
                     [](const auto& s, const auto& r) { return s.op == r.op && s.a == r.a && s.b == r.b; }))
          << static_cast<int>(wanted);
    }
  }
}

TEST(late_entities, compiled_and_interpreted_agree_to_the_last_bit) {
  using namespace rolling_disc;
  struct Rim : offset<Rim, Dmc, r * R::x>, fixed_in<R> {};
  constexpr auto v = velocity_of<Rim>, a = acceleration_of<Rim>;
  kanexpr::model derived = kanexpr::derive<System>();
  auto interpreted = derived.function(derived.get<v>()), accelerated = derived.function(derived.get<a>());
  const kanexpr::parameter_values<System> p(0.5, 2, 9.81);
  std::srand(3);
  for (int i = 0; i < 100; ++i) {
    const kanexpr::state<System> x = kanexpr::state<System>::Random();
    EXPECT_EQ((kanexpr::function<System, v>{}(x, p)), interpreted(x, p));
    EXPECT_EQ((kanexpr::function<System, a>{}(x, p)), accelerated(x, p));
  }
}

TEST(late_entities, are_checked_like_those_of_the_system) {
  using namespace bicycle;
  struct Growing : offset<Growing, Steer, u5 * Fork::x> {};
  struct Bent : direction_cosines<Bent, Fork, 0.6, 0.8, 0, 0.8, 0.6, 0, 0, 0, 1> {};
  kanexpr::model derived = kanexpr::derive<System>();
  EXPECT_EQ(derived.get<velocity_of<Growing>>().entries.size(), 0);
  EXPECT_EQ(derived.mistake(),
            "the offset of point Growing contains the speed u5; it may contain only coordinates");
  EXPECT_EQ(derived.get<velocity_of<Steer>>().entries.size(), 3); // the system itself is valid
  EXPECT_EQ(derived.mistake(), "");
  EXPECT_EQ(derived.get<angular_velocity_of<Bent>>().entries.size(), 0);
  EXPECT_TRUE(derived.mistake().starts_with("the direction cosines of frame Bent are not orthonormal"));
}
