/// \file
/// Eight numbers at a time, in whatever registers the instruction set has.
#pragma once

#include "data.hpp"

#pragma GCC diagnostic ignored "-Wsign-conversion" // in all kernels: sizes of small arrays are plain integers

#define SETTLE_INLINE inline __attribute__((always_inline))

namespace settle::mpm::kernel::SETTLE_VARIANT {

constexpr int n_lanes = 8;
typedef double Lanes __attribute__((vector_size(64)));
typedef std::int64_t Mask __attribute__((vector_size(64)));
typedef double HalfLanes __attribute__((vector_size(32)));
typedef std::uint8_t Bytes __attribute__((vector_size(8)));

SETTLE_INLINE Lanes load(const double* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
SETTLE_INLINE void store(double* to, const Lanes& lanes) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}
/// The first `count` of them; the rest is zero.
SETTLE_INLINE Lanes load(const double* from, int count) {
  if (count >= n_lanes) return load(from);
  double some[n_lanes] = {};
  for (int i = 0; i < count; ++i)
    some[i] = from[i];
  return load(some);
}
SETTLE_INLINE void store(double* to, const Lanes& lanes, int count) {
  if (count >= n_lanes) return store(to, lanes);
  double some[n_lanes];
  store(some, lanes);
  for (int i = 0; i < count; ++i)
    to[i] = some[i];
}
SETTLE_INLINE Lanes all(double v) {
  return Lanes{v, v, v, v, v, v, v, v};
}
/// Below 2^51; larger numbers come out as integers near them.
SETTLE_INLINE Lanes floor_of(const Lanes& x) {
  constexpr double integers_only = 6755399441055744.0; // 1.5 * 2^52: doubles around it are integers
  const Lanes nearest = (x + integers_only) - integers_only;
  return nearest > x ? nearest - 1.0 : nearest;
}
SETTLE_INLINE Lanes absolute(const Lanes& x) {
  return x < 0.0 ? -x : x;
}
/// In the order of the lanes.
SETTLE_INLINE double sum_of(const Lanes& x) {
  double sum = 0;
  for (int i = 0; i < n_lanes; ++i)
    sum += x[i];
  return sum;
}
SETTLE_INLINE double least_of(const Lanes& x) {
  double least = x[0];
  for (int i = 1; i < n_lanes; ++i)
    least = x[i] < least ? x[i] : least;
  return least;
}
SETTLE_INLINE bool any(const Mask& mask) {
  std::int64_t some = 0;
  for (int i = 0; i < n_lanes; ++i)
    some |= mask[i];
  return some != 0;
}
SETTLE_INLINE int least(int a, int b) {
  return a < b ? a : b;
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
