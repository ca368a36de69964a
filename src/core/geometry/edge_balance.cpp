// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_balance.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lamina {
namespace {

constexpr std::uint64_t kForwards = 1;

/// Vertex indices low and high (31 bits each suffice, see VertexWelder) and the direction in one number, so
/// that sorting puts the half-edges of an edge side by side.
std::uint64_t halfEdgeKey(std::uint32_t from, std::uint32_t to) {
  const std::uint64_t low = std::min(from, to);
  const std::uint64_t high = std::max(from, to);
  return (low << 32) | (high << 1) | (from < to ? kForwards : 0);
}

}  // namespace

bool isBalanced(const Mesh& mesh) {
  std::vector<std::uint64_t> keys;
  keys.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] != t[(i + 1) % 3]) keys.push_back(halfEdgeKey(t[i], t[(i + 1) % 3]));
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < keys.size();) {
    const std::uint64_t edge = keys[i] >> 1;
    int balance = 0;
    for (; i < keys.size() && keys[i] >> 1 == edge; ++i) balance += (keys[i] & kForwards) != 0 ? 1 : -1;
    if (balance != 0) return false;
  }
  return !keys.empty();
}

}  // namespace lamina
