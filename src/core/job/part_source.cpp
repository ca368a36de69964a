// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part_source.hpp"

#include <algorithm>

#include "lamina/geometry/parts.hpp"

namespace lamina {

SourcePart readPart(const std::string& part, const InputSettings& settings) {
  const std::vector<std::string> names = partNames();
  if (std::find(names.begin(), names.end(), part) != names.end()) {
    Mesh mesh = makePart(part);
    for (Point3& vertex : mesh.vertices) vertex *= settings.units.scale;
    return {std::move(mesh), {}};
  }
  return {readMesh(part, settings.units), {}};
}

}  // namespace lamina
