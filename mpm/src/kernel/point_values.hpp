/// \file
/// What the first pass of a step reads of its points, eight at a time: of neighbours, or of a cell each.
#pragma once

#include "law.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Of 8 n numbers those n apart: lane i of slot k is number k + n i.
template <int n>
SETTLE_INLINE void take_apart(const double* from, Lanes slot[n]) {
#ifdef __AVX512F__
  typedef std::int64_t Order __attribute__((vector_size(64)));
  if constexpr (n == 1) {
    slot[0] = load(from);
  } else if constexpr (n == 3) {
    const Lanes a = load(from), b = load(from + n_lanes), c = load(from + 2 * n_lanes);
    slot[0] =
        __builtin_shuffle(__builtin_shuffle(a, b, Order{0, 3, 6, 9, 12, 15, 0, 0}), c, Order{0, 1, 2, 3, 4, 5, 10, 13});
    slot[1] =
        __builtin_shuffle(__builtin_shuffle(a, b, Order{1, 4, 7, 10, 13, 0, 0, 0}), c, Order{0, 1, 2, 3, 4, 8, 11, 14});
    slot[2] =
        __builtin_shuffle(__builtin_shuffle(a, b, Order{2, 5, 8, 11, 14, 0, 0, 0}), c, Order{0, 1, 2, 3, 4, 9, 12, 15});
  } else {
    static_assert(n % 2 == 0);
    double parts[2][n_lanes * n / 2]; // even and odd numbers
    for (int k = 0; k < n / 2; ++k) {
      const Lanes low = load(from + 2 * n_lanes * k), high = load(from + 2 * n_lanes * k + n_lanes);
      store(parts[0] + n_lanes * k, __builtin_shuffle(low, high, Order{0, 2, 4, 6, 8, 10, 12, 14}));
      store(parts[1] + n_lanes * k, __builtin_shuffle(low, high, Order{1, 3, 5, 7, 9, 11, 13, 15}));
    }
    for (int odd = 0; odd < 2; ++odd) {
      Lanes half[n / 2];
      take_apart<n / 2>(parts[odd], half);
      for (int k = 0; k < n / 2; ++k)
        slot[2 * k + odd] = half[k];
    }
  }
#else
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n_lanes; ++i)
      slot[k][i] = from[k + n * i];
#endif
}

/// Values of 8 n points: lane i of slot k belongs to the k-th point of the i-th square; of neighbours where n is 1.
template <int dim, Weight weight, int n>
struct PointValues {
  static constexpr int mass = 0, volume = 1, position = 2, velocity = position + dim, stress = velocity + dim,
                       force = stress + n_felt<dim>, pull = force + (weight == Weight::with_force ? 2 : 0),
                       n_pulls = weight == Weight::uniform    ? 0
                                 : weight == Weight::by_layer ? 1
                                                              : 2;
  Lanes of[pull + n_pulls][n]; ///< pull: external force per mass, along the last axis first [m/s2]

  /// Component c of the stress.
  SETTLE_INLINE const Lanes* tension(int c) const { return of[stress + (dim == 2 && c == 3 ? 2 : c)]; }

  /// Reads the points p ... p + 7, `some` of which there are.
  SETTLE_INLINE void read(const Step& step, const PointArrays& points, std::size_t p, int some) requires(n == 1) {
    for_each_array(points, [&](int k, const double* array) { of[k][0] = load(array + p, some); });
    set_pull(step, points.layer + p, some);
  }
  /// Reads eight squares with n points each, the first one p.
  SETTLE_INLINE void read_squares(const Step& step, const PointArrays& points, std::size_t p) {
    for_each_array(points, [&](int k, const double* array) { take_apart<n>(array + p, of[k]); });
    set_pull(step, points.layer + p, n_lanes);
  }

private:
  /// Calls `read(k, array)` for every value that is read.
  template <class Read>
  SETTLE_INLINE static void for_each_array(const PointArrays& points, Read&& read) {
    read(mass, points.mass), read(volume, points.volume);
    for (int d = 0; d < dim; ++d)
      read(position + d, points.position[d]), read(velocity + d, points.velocity[d]);
    for (int k = 0; k < n_felt<dim>; ++k)
      read(stress + k, points.stress[felt<dim>(k)]);
    if constexpr (weight == Weight::with_force) read(force, points.force[0]), read(force + 1, points.force[1]);
  }
  SETTLE_INLINE void set_pull(const Step& step, const std::int32_t* layer, int some) {
    if constexpr (weight == Weight::uniform) return;
    for (int slot = 0; slot < n; ++slot) {
      Lanes gravity = all(0.0);
      for (int i = 0; i < least(some, n_lanes); ++i)
        gravity[i] = layer[slot + n * i] == step.ramped_layer ? step.ramped_gravity : step.gravity;
      of[pull][slot] = -gravity;
      if constexpr (weight == Weight::with_force)
        of[pull][slot] += of[force + 1][slot], of[pull + 1][slot] = of[force][slot];
    }
  }
};

/// Sum of `of(slot)` over the slots, in their order.
template <int n, class Of>
SETTLE_INLINE Lanes sum_of_slots(Of&& of) {
  Lanes sum = of(0);
#pragma GCC unroll 8
  for (int slot = 1; slot < n; ++slot)
    sum += of(slot);
  return sum;
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
