#pragma once

#include <string_view>

/// C code shared by the functions of a step. `@s@` is the prefix of its names. Each column of derivatives
/// belongs to an entry of the arguments x, r, h, p and t, in this order, so that the derivatives without
/// parameters come first.
namespace kanexpr::exporting {

inline constexpr std::string_view step_in_c = R"(
/* A step: each stage evaluates the rates at the point y = x + h a k, where k are the rates of the previous stage, and
   the state after the step is x + sum of h b k. Coordinates and speeds have separate a and b. Derivatives follow from
   those of the rates by the chain rule. */
enum { @s@_n = @n@, @s@_h = @h@, @s@_t = @t@, @s@_columns = @columns@, @s@_stages = @stages@, @s@_slopes = @slopes@ };
static const double @s@_a[@stages@][2] = {@a@};
static const double @s@_b[@stages@][2] = {@b@};
static const double @s@_when[@stages@] = {@when@};
/* Row and column of each entry of the derivatives. */
static const int @s@_slope_at[][2] = {@slope_at@};

typedef struct { const double *x, *p, *r; double h, t; } @s@_arguments;

static @s@_arguments @s@_take(const double **arg) {
  @s@_arguments at;
  at.x = @given@(arg[0]);
  at.r = @given@(arg[1]);
  at.p = @given@(arg[2]);
  at.h = *@given@(arg[3]);
  at.t = @time@;
  return at;
}

static double @s@_a_of(int stage, int i) { return @s@_a[stage][i >= @coordinates@]; }
static double @s@_b_of(int stage, int i) { return @s@_b[stage][i >= @coordinates@]; }

/* The point and the rates of each stage. */
static int @s@_points(const @s@_arguments *at, double *points) {
  int s, i;
  for (s = 0; s < @s@_stages; ++s) {
    double *y = points + 2 * s * @s@_n;
    const double *before = s > 0 ? y - @s@_n : at->x;
    for (i = 0; i < @s@_n; ++i) y[i] = at->x[i] + @s@_a_of(s, i) * at->h * before[i];
    if (@kernels@_rates(at->t + @s@_when[s] * at->h, y, at->p, at->r, y + @s@_n) != 0) return 1;
  }
  return 0;
}

/* The derivatives of a stage's rates by the arguments of the stage. */
static int @s@_slope(const @s@_arguments *at, int s, int by_all, const double *points, double *slope) {
  const double *y = points + 2 * s * @s@_n;
  const double t = at->t + @s@_when[s] * at->h;
  (void)by_all;
@jacobian@  return 0;
}

/* Applies the chain rule to derivatives by a stage's arguments; `by` are the derivatives of the stage's point. */
static void @s@_chain(int s, const int (*places)[2], int entries, const double *slope, const double *by, int columns,
                      double *sum) {
  int e, c;
  for (e = 0; e < entries; ++e) {
    const int j = places[e][1];
    double *row = sum + places[e][0] * @s@_columns;
    if (j < @s@_n) {
      const double *of = by + j * @s@_columns;
      for (c = 0; c < columns; ++c) row[c] += slope[e] * of[c];
    } else {
      row[j] += slope[e];
      if (j == @s@_t) row[@s@_h] += @s@_when[s] * slope[e];
    }
  }
}

/* The derivatives of the point of each stage, followed by those of the step. */
static int @s@_moved(const @s@_arguments *at, int by_all, const double *points, double *slopes, double *by, double *w) {
  const int size = @s@_n * @s@_columns, columns = by_all ? @s@_columns : @basic@;
  int s, i, c;
  double *after = by + @s@_stages * size;
  for (i = 0; i < (@s@_stages + 1) * size; ++i) by[i] = 0;
  for (s = 0; s <= @s@_stages; ++s)
    for (i = 0; i < @s@_n; ++i) by[s * size + i * @s@_columns + i] = 1;
  for (s = 0; s < @s@_stages; ++s) {
    const double *rate = points + (2 * s + 1) * @s@_n;
    if (@s@_slope(at, s, by_all, points, slopes + s * @s@_slopes)) return 1;
    for (i = 0; i < size; ++i) w[i] = 0;
    @s@_chain(s, @s@_slope_at, by_all ? @s@_slopes : @basic_slopes@, slopes + s * @s@_slopes, by + s * size, columns, w);
    for (i = 0; i < @s@_n; ++i) {
      double *next = by + (s + 1) * size + i * @s@_columns, *end = after + i * @s@_columns;
      const double b = @s@_b_of(s, i), a = s + 1 < @s@_stages ? @s@_a_of(s + 1, i) : 0;
      for (c = 0; c < columns; ++c) {
        const double change = at->h * w[i * @s@_columns + c] + (c == @s@_h ? rate[i] : 0);
        end[c] += b * change;
        if (s + 1 < @s@_stages) next[c] += a * change;
      }
    }
  }
  return 0;
}

/* The weights of a stage's rates, without the factor h; `of_next` are those of the next point. */
static void @s@_weigh(int s, const double *weights, const double *of_next, double *weight) {
  int i;
  for (i = 0; i < @s@_n; ++i)
    weight[i] = @s@_b_of(s, i) * weights[i] + (s + 1 < @s@_stages ? @s@_a_of(s + 1, i) * of_next[i] : 0);
}
)";

/// ∂²(λᵀ x⁺)/∂z²: the sum over the stages of Wᵀ H W, where W are the derivatives of the stage's arguments and
/// H the weighted second derivatives of its rates, plus the terms from the product of h and the rates.
inline constexpr std::string_view second_order_of_step_in_c = R"(
static const int @s@_curve_at[][2] = {@curve_at@};

/* The second derivatives of the weighted state after the step; only the upper triangle is filled. */
static int @s@_curved(const @s@_arguments *at, int by_all, const double *points, const double *slopes, const double *by,
                      const double *weights, double *all, double *w) {
  const int columns = by_all ? @s@_columns : @basic@, entries = by_all ? @curves@ : @basic_curves@;
  const int slopes_of = by_all ? @s@_slopes : @basic_slopes@;
  double *weight = w, *of_next = weight + @s@_n, *gradient = of_next + @s@_n, *curve = gradient + @s@_columns,
         *moved = curve + @curves@;
  int s, i, c, d, e;
  for (i = 0; i < @s@_columns * @s@_columns; ++i) all[i] = 0;
  for (s = @s@_stages - 1; s >= 0; --s) {
    const double *y = points + 2 * s * @s@_n, *slope = slopes + s * @s@_slopes, *of = by + s * @s@_n * @s@_columns;
    const double t = at->t + @s@_when[s] * at->h;
    @s@_weigh(s, weights, of_next, weight);
    for (c = 0; c < columns; ++c) gradient[c] = 0;
    for (e = 0; e < slopes_of; ++e) gradient[@s@_slope_at[e][1]] += slope[e] * weight[@s@_slope_at[e][0]];
@turn@    for (c = 0; c < columns; ++c) {
      double sum = c < @s@_n ? 0 : gradient[c];
      for (i = 0; i < @s@_n; ++i) sum += gradient[i] * of[i * @s@_columns + c];
      if (c < @s@_h)
        all[c * @s@_columns + @s@_h] += sum;
      else
        all[@s@_h * @s@_columns + c] += c == @s@_h ? 2 * sum : sum;
    }
    for (i = 0; i < @s@_n; ++i) {
      of_next[i] = at->h * gradient[i];
      weight[i] *= at->h;
    }
@hessian@    for (i = 0; i < columns * @s@_columns; ++i) moved[i] = 0;
    @s@_chain(s, @s@_curve_at, entries, curve, of, columns, moved);
    for (i = 0; i < @s@_n; ++i)
      for (c = 0; c < columns; ++c)
        if (of[i * @s@_columns + c] != 0)
          for (d = c; d < columns; ++d) all[c * @s@_columns + d] += of[i * @s@_columns + c] * moved[i * @s@_columns + d];
    for (c = @s@_n; c < columns; ++c)
      for (d = c; d < columns; ++d) all[c * @s@_columns + d] += moved[c * @s@_columns + d];
@turned@  }
  return 0;
}
)";

/// Computes the points, slopes and derivatives of all stages; `after` holds those of the step, and `rest` is
/// free.
inline constexpr std::string_view moved_in_c =
    R"(  const @s@_arguments given = @s@_take(arg), *const at = &given;
  double *slopes = w + 2 * @s@_stages * @s@_n, *by = slopes + @s@_stages * @s@_slopes,
         *after = by + @s@_stages * @s@_n * @s@_columns, *rest = after + @s@_n * @s@_columns;
  if (@s@_points(at, w) || @s@_moved(at, by_all, w, slopes, by, rest)) return 1;
)";

/// Computes the derivatives `total` of a directional derivative: those of a stage's rates follow from the
/// second derivatives of the rates along the stage's direction, and from the derivatives of that direction.
inline constexpr std::string_view moved_along_in_c =
    R"(  const @s@_arguments given = @s@_take(arg), *const at = &given;
  enum { size = @s@_n * @s@_columns };
  double *slopes = w + 2 * @s@_stages * @s@_n, *by = slopes + @s@_stages * @s@_slopes,
         *after = by + @s@_stages * size, *change = after + size, *change_along = change + size,
         *bent = change_along + size, *total = bent + size, *direction = total + size,
         *rate_along = direction + @s@_columns, *bend = rate_along + @s@_n;
  int slopes_of, bends_of, columns;
  static const int bend_at[][2] = {@bend_at@};
@take_direction@  if (@s@_points(at, w) || @s@_moved(at, by_all, w, slopes, by, change)) return 1;
  columns = by_all ? @s@_columns : @basic@;
  slopes_of = by_all ? @s@_slopes : @basic_slopes@;
  bends_of = by_all ? @all_bends@ : @basic_bends@;
  for (i = 0; i < 2 * size; ++i) bent[i] = 0;
  for (s = 0; s < @s@_stages; ++s) {
    const double *slope = slopes + s * @s@_slopes, *of = by + s * size;
@directed@@directional_jacobian@    for (i = 0; i < @s@_n; ++i) rate_along[i] = 0;
    for (i = 0; i < 2 * size; ++i) change[i] = 0;
    for (e = 0; e < slopes_of; ++e) {
      const int row = @s@_slope_at[e][0], j = @s@_slope_at[e][1];
      rate_along[row] += slope[e] * direction[j - (j > @s@_h)];
      if (j < @s@_n)
        for (c = 0; c < columns; ++c) change_along[row * @s@_columns + c] += slope[e] * bent[j * @s@_columns + c];
    }
    @s@_chain(s, @s@_slope_at, slopes_of, slope, of, columns, change);
    @s@_chain(s, bend_at, bends_of, bend, of, columns, change_along);
    for (i = 0; i < @s@_n; ++i)
      for (c = 0; c < columns; ++c) {
        const int k = i * @s@_columns + c;
        const double all = at->h * change_along[k] + along_h * change[k] + (c == @s@_h ? rate_along[i] : 0);
        total[k] += @s@_b_of(s, i) * all;
        bent[k] = s + 1 < @s@_stages ? @s@_a_of(s + 1, i) * all : 0;
      }
  }
)";

} // namespace kanexpr::exporting
