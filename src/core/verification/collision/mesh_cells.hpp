// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/spatial/solid_angle.hpp"

namespace lamina {

/// Cubic cells about a mesh, each with the information whether triangles enter it. A cell without triangles
/// lies as a whole on one side of a closed mesh; the side is computed at the first request. This decides most
/// boxes and points near a body without testing a triangle. Answers are those of `SolidAngle`, and do not
/// depend on earlier requests. Calls may come from several threads.
class MeshCells {
 public:
  /// @param mesh  must outlive this
  explicit MeshCells(const Mesh& mesh);

  /// Whether no triangle enters a box; false may mean that the box covers many cells, or that a triangle is
  /// near.
  bool isFarFrom(const Box3& box) const;

  /// As `SolidAngle::isWithin`; no point beyond the mesh's bounds is.
  bool isWithin(const Point3& point) const;

 private:
  enum class State : std::uint8_t { Unknown, Outside, Within, Touched };
  using Cell = std::array<int, 3>;

  /// Cells that a box reaches, the last one included.
  struct Range {
    Cell first{};
    Cell last{};
    std::size_t count() const;
  };

  Range cellsOf(const Box3& box) const;
  std::size_t indexOf(const Cell& cell) const;
  Box3 boxOf(const Cell& cell) const;
  void touch(const std::array<Point3, 3>& corners);

  SolidAngle inside_;
  Box3 bounds_;
  bool is_closed_ = false;
  double side_mm_ = 1.0;
  Cell counts_{1, 1, 1};
  mutable std::vector<std::atomic<State>> states_;
};

}  // namespace lamina
