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

constexpr token by_symbol(token_kind what, const scalar<1>& symbol) {
  token t = with(what);
  t.symbol = symbol.tokens[0].symbol;
  return t.symbol != nullptr ? t : misused(misuse::partial);
}

template <class Other>
concept no_symbol = written<Other> && !std::derived_from<Other, scalar<1>>;

/// Motions are relative to the inertial frame; `velocity_of<P, N>` is a mistake.
template <class... Others>
constexpr auto in_the_inertial_frame(const vector<1>& motion) {
  if constexpr (sizeof...(Others) == 0)
    return motion;
  else
    return misused<vector>(motion, misuse::seen_motion);
}

} // namespace describe

/// The position of `Point` relative to `From`; both must descend from the same origin.
template <class Point, class... From>
inline constexpr auto position_of =
    describe::misused<vector>(describe::motion_of(describe::token_kind::position, &describe::point_of<Point>,
                                                  !is_known_to_all_files<Point>),
                              describe::misuse::points);

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

template <class Frame, class... In>
inline constexpr auto angular_acceleration_of = describe::in_the_inertial_frame<In...>(describe::motion_of(
    describe::token_kind::angular_acceleration, &describe::frame_of<Frame>, !is_known_to_all_files<Frame>));

/// The time derivative of a vector in `Frame`.
template <class Frame, int size>
constexpr vector<size + 1> derivative_in(const vector<size>& v) {
  describe::token t = describe::with(describe::token_kind::derivative);
  t.frame = &describe::frame_of<Frame>;
  t.is_of_one_file = !is_known_to_all_files<Frame>;
  return describe::join<vector<size + 1>>(v.tokens, t);
}

/// The time derivative of a scalar.
template <int size>
constexpr scalar<size + 1> derivative(const scalar<size>& s) {
  return describe::join<scalar<size + 1>>(s.tokens, describe::with(describe::token_kind::derivative));
}

/// The same vector, expressed by its components in the axes of `Frame`.
template <class Frame, int size>
constexpr vector<size + 1> in_axes_of(const vector<size>& v) {
  describe::token t = describe::with(describe::token_kind::in_axes);
  t.frame = &describe::frame_of<Frame>;
  t.is_of_one_file = !is_known_to_all_files<Frame>;
  return describe::join<vector<size + 1>>(v.tokens, t);
}

/// The partial derivative with respect to a symbol; that of a vector is taken component by component in the
/// vector's own axes. `partial(velocity_of<P>, u1)` is a partial velocity.
template <int size>
constexpr scalar<size + 1> partial(const scalar<size>& s, const scalar<1>& symbol) {
  return describe::join<scalar<size + 1>>(s.tokens,
                                          describe::by_symbol(describe::token_kind::partial, symbol));
}
template <int size>
constexpr vector<size + 1> partial(const vector<size>& v, const scalar<1>& symbol) {
  return describe::join<vector<size + 1>>(v.tokens,
                                          describe::by_symbol(describe::token_kind::partial, symbol));
}

template <class Operand, describe::no_symbol Symbol>
  requires describe::expression_of_a_model<Operand>
constexpr auto partial(const Operand& x, const Symbol& by) {
  return describe::misused<vector>(x, by, describe::misuse::partial);
}

// derivatives and axes with arguments of the wrong kind
template <describe::no_scalar Operand>
constexpr auto derivative(const Operand& x) {
  return describe::misused<scalar>(x, describe::misuse::unseen_derivative);
}
template <class Frame, describe::no_vector Operand>
constexpr auto derivative_in(const Operand& x) {
  return describe::misused<vector>(x, describe::misuse::seen_scalar);
}
template <describe::written Operand>
constexpr auto derivative_in(const Operand& x) {
  return describe::misused<vector>(x, describe::misuse::unseen_derivative);
}
template <class Frame, describe::no_vector Operand>
constexpr auto in_axes_of(const Operand& x) {
  return describe::misused<vector>(x, describe::misuse::axes);
}
template <describe::written Operand>
constexpr auto in_axes_of(const Operand& x) {
  return describe::misused<vector>(x, describe::misuse::axes);
}

/// The matrix of partial derivatives, one column per symbol; for a vector, of its components in inertial
/// axes.
template <int size, int columns>
struct jacobian_matrix {
  bool of_vector;
  describe::token tokens[static_cast<std::size_t>(size)];
  describe::token by[static_cast<std::size_t>(columns)];
};

template <int size, std::derived_from<scalar<1>>... Symbols>
constexpr auto jacobian(const vector<size>& v, const Symbols&... symbols) {
  jacobian_matrix<size, sizeof...(Symbols)> j{
      true, {}, {static_cast<const scalar<1>&>(symbols).tokens[0]...}};
  for (int i = 0; i < size; ++i) j.tokens[i] = v.tokens[i];
  return j;
}
template <int size, std::derived_from<scalar<1>>... Symbols>
constexpr auto jacobian(const scalar<size>& s, const Symbols&... symbols) {
  jacobian_matrix<size, sizeof...(Symbols)> j{
      false, {}, {static_cast<const scalar<1>&>(symbols).tokens[0]...}};
  for (int i = 0; i < size; ++i) j.tokens[i] = s.tokens[i];
  return j;
}
template <describe::expression_of_a_model Operand, class... Symbols>
constexpr auto jacobian(const Operand& x, const Symbols&...) {
  return describe::misused<vector>(x, describe::misuse::partial);
}

} // namespace kanexpr
