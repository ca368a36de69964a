// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "indexed_faces.hpp"

#include "lamina/base/error.hpp"
#include "vertex_welder.hpp"

namespace lamina {

void addFan(IndexedFaces& faces, const std::vector<std::uint32_t>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    faces.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

Mesh weld(const IndexedFaces& faces, const std::string& name) {
  constexpr std::uint32_t kUnknown = 0xFFFFFFFF;
  VertexWelder<double> welder(faces.positions.size());
  std::vector<std::uint32_t> welded(faces.positions.size(), kUnknown);
  Mesh mesh;
  mesh.triangles.reserve(faces.triangles.size());
  for (const Triangle& triangle : faces.triangles) {
    Triangle& added = mesh.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t position = triangle[i];
      if (position >= welded.size())
        throw InvalidMesh(name + ": triangle " + std::to_string(mesh.triangles.size() - 1) +
                          " names vertex " + std::to_string(position) + "; there are " +
                          std::to_string(welded.size()));
      if (welded[position] == kUnknown) welded[position] = welder.add(faces.positions[position]);
      added[i] = welded[position];
    }
  }
  mesh.vertices = welder.vertices();
  return mesh;
}

}  // namespace lamina
