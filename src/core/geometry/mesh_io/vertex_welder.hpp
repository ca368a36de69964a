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

/// Gives exactly equal coordinates the same index, in order of first appearance; -0 equals +0. A hash table
/// with open addressing that holds indices only, so that it stays small.
template <class Scalar>
class VertexWelder {
 public:
  using Coordinates = std::array<Scalar, 3>;
  using Bits = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
  /// The bits of the coordinates with negative zeros made positive: equal if and only if the coordinates are
  /// welded.
  using Key = std::array<Bits, 3>;

  explicit VertexWelder(std::size_t expected_vertices) {
    std::size_t capacity = 16;
    while (capacity < 2 * expected_vertices) capacity *= 2;
    resize(capacity);
    keys_.reserve(expected_vertices);
  }

  static Key keyOf(const Coordinates& c) {
    const Coordinates positive = {c[0] + Scalar(0), c[1] + Scalar(0), c[2] + Scalar(0)};
    Key key;
    std::memcpy(key.data(), positive.data(), sizeof key);
    return key;
  }

  static std::uint64_t hash(const Key& key) {
    std::uint64_t h = key[0] * 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 29) ^ key[1]) * 0xBF58476D1CE4E5B9ULL;
    h = (h ^ (h >> 32) ^ key[2]) * 0x94D049BB133111EBULL;
    return h ^ (h >> 31);
  }

  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots_[hash & mask_]); }

  /// The index of coordinates, from their key and hash.
  std::uint32_t add(const Key& key, std::uint64_t hash) {
    std::size_t i = hash & mask_;
    for (; slots_[i] != kFree; i = (i + 1) & mask_)
      if (keys_[slots_[i]] == key) return slots_[i];
    const auto index = static_cast<std::uint32_t>(keys_.size());
    slots_[i] = index;
    keys_.push_back(key);
    if (2 * keys_.size() > slots_.size()) grow();
    return index;
  }

  std::uint32_t add(const Coordinates& coordinates) {
    const Key key = keyOf(coordinates);
    return add(key, hash(key));
  }

  std::vector<Point3> vertices() const {
    std::vector<Point3> points;
    points.reserve(keys_.size());
    for (const Key& key : keys_) {
      Coordinates c;
      std::memcpy(c.data(), key.data(), sizeof c);
      points.emplace_back(c[0], c[1], c[2]);
    }
    return points;
  }

 private:
  static constexpr std::uint32_t kFree = 0xFFFFFFFF;

  void resize(std::size_t capacity) {
    slots_.assign(capacity, kFree);
    mask_ = capacity - 1;
  }

  void grow() {
    if (keys_.size() >= kFree / 2) throw InvalidMesh("more than 2147483647 vertices; fewer are supported");
    resize(2 * slots_.size());
    for (std::uint32_t index = 0; index < keys_.size(); ++index) {
      std::size_t i = hash(keys_[index]) & mask_;
      while (slots_[i] != kFree) i = (i + 1) & mask_;
      slots_[i] = index;
    }
  }

  std::vector<std::uint32_t> slots_;
  std::size_t mask_ = 0;
  std::vector<Key> keys_;
};

}  // namespace lamina
