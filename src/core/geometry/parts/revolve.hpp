// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The solid of revolution about z of the area inside a counter-clockwise outline of (radius, z) points, in
/// `segments` flat segments. Points of radius 0 become one vertex on the axis; an outline may run along the
/// axis.
Mesh revolve(const Polygon& outline, int segments);

}  // namespace lamina
