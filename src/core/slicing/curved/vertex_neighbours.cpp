// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/vertex_neighbours.hpp"

#include <algorithm>
#include <utility>

namespace lamina {

VertexNeighbours::VertexNeighbours(const Mesh& mesh) : first_(mesh.vertices.size() + 1, 0) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  pairs.reserve(6 * mesh.triangles.size());
  for (const Triangle& corner : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.emplace_back(corner[k], corner[(k + 1) % 3]);
      pairs.emplace_back(corner[(k + 1) % 3], corner[k]);
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  list_.reserve(pairs.size());
  for (const auto& [from, to] : pairs) {
    list_.push_back(to);
    ++first_[from + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

}  // namespace lamina
