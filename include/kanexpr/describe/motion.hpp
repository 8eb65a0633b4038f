#pragma once

#include <kanexpr/describe/point.hpp>
#include <kanexpr/describe/symbol.hpp>

/// The motion of a model's entities, as expressions that `function` compiles and `derive` prints.
namespace kanexpr {

namespace describe {

constexpr vector<1> motion_of(token_kind what, const point_record* point, bool is_of_one_file) {
  token t = with(what);
  t.point = point;
  t.is_of_one_file = is_of_one_file;
  return {{t}};
}

constexpr vector<1> motion_of(token_kind what, const frame_record* frame, bool is_of_one_file) {
  token t = with(what);
  t.frame = frame;
  t.is_of_one_file = is_of_one_file;
  return {{t}};
}

template <class Frame>
constexpr token in_frame(token_kind what) {
  return motion_of(what, &frame_of<Frame>, !is_known_to_all_files<Frame>).tokens[0];
}

constexpr token by_symbol(token_kind what, const scalar<1>& symbol) {
  token t = with(what);
  t.symbol = symbol.tokens[0].symbol;
  return t.symbol != nullptr ? t : misused(misuse::partial);
}

/// Motions are relative to the inertial frame; `velocity_of<P, N>` is a mistake.
template <class... Others>
constexpr auto in_the_inertial_frame(const vector<1>& motion) {
  if constexpr (sizeof...(Others) == 0)
    return motion;
  else
    return misused<shape::vector>(misuse::motion_in_frame, motion);
}

/// A frame, and the frame relative to which its orientation and its declared angular velocity are given.
using kinematics_of_frame = postfix_expression<shape::kinematics, 2>;

constexpr kinematics_of_frame kinematics_between(const frame_record* frame, const frame_record* reference,
                                                 bool is_of_one_file) {
  kinematics_of_frame both{{with(token_kind::angular_velocity), with(token_kind::angular_velocity)}};
  both.tokens[0].frame = frame;
  both.tokens[1].frame = reference;
  both.tokens[0].is_of_one_file = is_of_one_file;
  return both;
}

} // namespace describe

/// The position of `Point` relative to `From`; both must descend from the same origin.
template <class Point, class... From>
inline constexpr auto position_of = describe::misused<describe::shape::vector>(
    describe::misuse::points, describe::motion_of(describe::token_kind::position, &describe::point_of<Point>,
                                                  !is_known_to_all_files<Point>));

template <class Point, class From>
inline constexpr auto position_of<Point, From> =
    describe::motion_of(describe::token_kind::position, &describe::point_of<Point>,
                        !is_known_to_all_files<Point>) -
    describe::motion_of(describe::token_kind::position, &describe::point_of<From>,
                        !is_known_to_all_files<From>);

/// The velocity of a point in the inertial frame.
template <class Point, class... In>
inline constexpr auto velocity_of = describe::in_the_inertial_frame<In...>(describe::motion_of(
    describe::token_kind::velocity, &describe::point_of<Point>, !is_known_to_all_files<Point>));

/// The acceleration of a point in the inertial frame; it contains the rates of the speeds.
template <class Point, class... In>
inline constexpr auto acceleration_of = describe::in_the_inertial_frame<In...>(describe::motion_of(
    describe::token_kind::acceleration, &describe::point_of<Point>, !is_known_to_all_files<Point>));

/// The angular velocity of a frame in the inertial frame. The angular velocity of one frame in another is the
/// difference of two of these.
template <class Frame, class... In>
inline constexpr auto angular_velocity_of = describe::in_the_inertial_frame<In...>(describe::motion_of(
    describe::token_kind::angular_velocity, &describe::frame_of<Frame>, !is_known_to_all_files<Frame>));

/// The angular acceleration of a frame in the inertial frame, the time derivative of its angular
/// velocity; it contains the rates of the speeds.
template <class Frame, class... In>
inline constexpr auto angular_acceleration_of = describe::in_the_inertial_frame<In...>(describe::motion_of(
    describe::token_kind::angular_acceleration, &describe::frame_of<Frame>, !is_known_to_all_files<Frame>));

/// The time derivative of a vector in `Frame`.
template <class Frame, describe::written Operand>
constexpr auto derivative_in(const Operand& v) {
  if constexpr (describe::shape_of_operand<Operand> == describe::shape::vector)
    return describe::joined<describe::shape::vector>(
        describe::in_frame<Frame>(describe::token_kind::derivative), v);
  else
    return describe::misused<describe::shape::vector>(describe::misuse::scalar_derivative_in_frame, v);
}
template <describe::written Operand>
constexpr auto derivative_in(const Operand& v) {
  return describe::misused<describe::shape::vector>(describe::misuse::derivative_without_frame, v);
}

/// The time derivative of a scalar.
template <describe::expression_of_a_model Operand>
constexpr auto derivative(const Operand& s) {
  if constexpr (describe::are_scalars<Operand>)
    return describe::joined<describe::shape::scalar>(describe::with(describe::token_kind::derivative), s);
  else
    return describe::misused<describe::shape::scalar>(describe::misuse::derivative_without_frame, s);
}

/// The same vector, expressed by its components in the axes of `Frame`.
template <class Frame, describe::written Operand>
constexpr auto in_axes_of(const Operand& v) {
  if constexpr (describe::shape_of_operand<Operand> == describe::shape::vector)
    return describe::joined<describe::shape::vector>(describe::in_frame<Frame>(describe::token_kind::in_axes),
                                                     v);
  else
    return describe::misused<describe::shape::vector>(describe::misuse::axes, v);
}
template <describe::written Operand>
constexpr auto in_axes_of(const Operand& v) {
  return describe::misused<describe::shape::vector>(describe::misuse::axes, v);
}

/// The partial derivative with respect to a symbol; that of a vector is taken component by component in the
/// vector's own axes. `partial(velocity_of<P>, u1)` is a partial velocity.
template <describe::expression_of_a_model Operand, describe::written Symbol>
constexpr auto partial(const Operand& x, const Symbol& symbol) {
  constexpr describe::shape kind = describe::shape_of_operand<Operand>;
  if constexpr (std::derived_from<Symbol, scalar<1>> &&
                (kind == describe::shape::scalar || kind == describe::shape::vector))
    return describe::joined<kind>(describe::by_symbol(describe::token_kind::partial, symbol), x);
  else
    return describe::misused<describe::shape::vector>(describe::misuse::partial, x, symbol);
}

/// The matrix of partial derivatives, one column per symbol; for a vector, of its components in inertial
/// axes.
template <int size, int columns>
struct jacobian_matrix {
  bool of_vector;
  describe::token tokens[static_cast<std::size_t>(size)];
  describe::token by[static_cast<std::size_t>(columns)];
};

/// The matrix of the partial derivatives of a scalar or a vector with respect to symbols, one column per
/// symbol: `jacobian(position_of<P, O>, q1, q2)`. A vector has three rows, its components in inertial
/// axes.
template <describe::expression_of_a_model Operand, class... Symbols>
constexpr auto jacobian(const Operand& x, const Symbols&... symbols) {
  constexpr describe::shape kind = describe::shape_of_operand<Operand>;
  if constexpr ((std::derived_from<Symbols, scalar<1>> && ...) &&
                (kind == describe::shape::scalar || kind == describe::shape::vector)) {
    jacobian_matrix<describe::size_of_all<Operand>, sizeof...(Symbols)> j{
        kind == describe::shape::vector, {}, {static_cast<const scalar<1>&>(symbols).tokens[0]...}};
    describe::append(j.tokens, x.tokens);
    return j;
  } else {
    return describe::misused<describe::shape::vector>(describe::misuse::partial, x);
  }
}

/// `kinematics<simple>` adds the kinematic differential equations q̇ = u of all coordinates whose rates
/// appear in no other equation. The first of these coordinates is paired with the first speed that appears in
/// no other equation, and so on.
inline constexpr describe::postfix_expression<describe::shape::simple, 1> simple{
    {describe::with(describe::token_kind::number)}};

/// The kinematic differential equations of a frame whose angular velocity is declared. They equate the
/// angular velocity that follows from its orientation in `Reference` and the one in
/// `angular_velocity<Reference, …>`. There are three equations, or four for a quaternion:
/// `kinematics<kinematics_of<B, N>, dot(q4) == u4>`.
template <class Frame, class... Reference>
inline constexpr describe::kinematics_of_frame kinematics_of =
    describe::kinematics_between(&describe::frame_of<Frame>, nullptr, !is_known_to_all_files<Frame>);

template <class Frame, class Reference>
inline constexpr describe::kinematics_of_frame kinematics_of<Frame, Reference> =
    describe::kinematics_between(&describe::frame_of<Frame>, &describe::frame_of<Reference>,
                                 !is_known_to_all_files<Frame> || !is_known_to_all_files<Reference>);

} // namespace kanexpr
