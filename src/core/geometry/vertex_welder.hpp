// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Gives exactly equal coordinates the same index (-0 equals +0), in order of first appearance. Open
/// addressing with the coordinates inside the slots: one cache line a look-up.
template <class Scalar>
class VertexWelder {
 public:
  using Coordinates = std::array<Scalar, 3>;

  explicit VertexWelder(std::size_t expected_vertices) {
    std::size_t capacity = 16;
    while (capacity < 2 * expected_vertices) capacity *= 2;
    resize(capacity);
    vertices_.reserve(expected_vertices);
  }

  static Coordinates withoutNegativeZero(const Coordinates& c) {
    return {c[0] + Scalar(0), c[1] + Scalar(0), c[2] + Scalar(0)};
  }

  static std::uint64_t hash(const Coordinates& coordinates) {
    std::array<Bits, 3> bits;
    std::memcpy(bits.data(), coordinates.data(), sizeof bits);
    std::uint64_t h = bits[0] * 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 29) ^ bits[1]) * 0xBF58476D1CE4E5B9ULL;
    h = (h ^ (h >> 32) ^ bits[2]) * 0x94D049BB133111EBULL;
    return h ^ (h >> 31);
  }

  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots_[hash & mask_]); }

  /// The index of the coordinates, whose negative zeros are gone and whose hash is known.
  std::uint32_t add(const Coordinates& coordinates, std::uint64_t hash) {
    std::size_t i = hash & mask_;
    for (; slots_[i].index != kFree; i = (i + 1) & mask_)
      if (std::memcmp(&slots_[i].coordinates, &coordinates, sizeof coordinates) == 0) return slots_[i].index;
    const auto index = static_cast<std::uint32_t>(vertices_.size());
    slots_[i] = {coordinates, index};
    vertices_.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
    if (2 * vertices_.size() > slots_.size()) grow();
    return index;
  }

  std::uint32_t add(const Coordinates& coordinates) {
    const Coordinates key = withoutNegativeZero(coordinates);
    return add(key, hash(key));
  }

  std::vector<Point3> takeVertices() { return std::move(vertices_); }

 private:
  using Bits = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
  static constexpr std::uint32_t kFree = 0xFFFFFFFF;
  struct Slot {
    Coordinates coordinates{};
    std::uint32_t index = kFree;
  };

  void resize(std::size_t capacity) {
    slots_.assign(capacity, Slot{});
    mask_ = capacity - 1;
  }

  void grow() {
    if (vertices_.size() >= kFree / 2)
      throw InvalidMesh("more than 2147483647 vertices; fewer are supported");
    const std::vector<Slot> old = std::move(slots_);
    resize(2 * old.size());
    for (const Slot& slot : old) {
      if (slot.index == kFree) continue;
      std::size_t i = hash(slot.coordinates) & mask_;
      while (slots_[i].index != kFree) i = (i + 1) & mask_;
      slots_[i] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
  std::vector<Point3> vertices_;
};

}  // namespace lamina
