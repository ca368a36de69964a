// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The faces that have a point between two heights [mm].
Mesh facesBetween(const Mesh& mesh, double low, double high);

/// The faces that come within a distance of a place.
Mesh facesNear(const Mesh& mesh, const Point3& place, double within_mm);

}  // namespace lamina
