// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/box_mesh.hpp"

namespace lamina {

Mesh boxMesh(const Box3& box) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    Point3 point = box.low;
    for (int i = 0; i < 3; ++i)
      if ((corner >> i & 1) != 0) point[i] = box.high[i];
    mesh.vertices.push_back(point);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace lamina
