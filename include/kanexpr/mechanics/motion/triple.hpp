#pragma once

#include <kanexpr/numeric/elementary.hpp>

namespace kanexpr::mechanics {

/// A numeric vector.
struct triple {
  double x = 0, y = 0, z = 0;

  constexpr double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  friend constexpr triple operator+(triple a, triple b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr triple operator-(triple a, triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr triple operator*(double s, triple a) { return {s * a.x, s * a.y, s * a.z}; }
};

constexpr double dot(triple a, triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr triple cross(triple a, triple b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double length(triple a) { return numeric::elementary::sqrt(dot(a, a)); }

/// Three vectors: the basis of one frame in the axes of another, or the columns of a dyadic.
struct triad {
  triple x{}, y{}, z{};

  constexpr triple& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr const triple& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr triple operator*(triple v) const { return v.x * x + v.y * y + v.z * z; }
  /// The components of `v` along the vectors of an orthonormal triad.
  constexpr triple along(triple v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  friend constexpr triad operator*(const triad& a, const triad& b) { return {a * b.x, a * b.y, a * b.z}; }
  friend constexpr triad operator*(double s, const triad& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr triad operator+(const triad& a, const triad& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
};

/// The columns of a⊗b.
constexpr triad outer(triple a, triple b) { return {b.x * a, b.y * a, b.z * a}; }
/// s times the unit dyadic.
constexpr triad diagonal(double s) { return {{s, 0, 0}, {0, s, 0}, {0, 0, s}}; }

/// The span of some vectors, all of which must be longer than the rounding error.
class span_of_triples {
public:
  constexpr void add(triple v) {
    if (size_ < 3 && !holds(v))
      basis_[size_++] = outside(v), basis_[size_ - 1] = (1 / length(basis_[size_ - 1])) * basis_[size_ - 1];
  }
  constexpr bool holds(triple v) const { return length(outside(v)) <= 1e-9 * length(v); }
  constexpr bool holds(const span_of_triples& other) const {
    for (int i = 0; i < other.size_; ++i)
      if (!holds(other.basis_[i])) return false;
    return true;
  }
  constexpr int size() const { return size_; }

private:
  constexpr triple outside(triple v) const {
    for (int twice = 0; twice < 2; ++twice) // repeated to remove rounding errors
      for (int i = 0; i < size_; ++i) v = v - dot(basis_[i], v) * basis_[i];
    return v;
  }

  triple basis_[3];
  int size_ = 0;
};

} // namespace kanexpr::mechanics
