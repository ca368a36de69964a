// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The neighbours of each vertex of a mesh: the vertices it shares an edge with, in ascending order.
class VertexNeighbours {
 public:
  explicit VertexNeighbours(const Mesh& mesh);

  struct Range {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };

  Range of(std::uint32_t vertex) const {
    return {list_.data() + first_[vertex], list_.data() + first_[vertex + 1]};
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> list_;
};

}  // namespace lamina
