// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "lamina/slicing/curved/curved_layers.hpp"

namespace lamina {

/// What all schemes of curved layers start from. The mesh, topology and settings must outlive it.
struct CurvedPart {
  const Mesh& mesh;
  const MeshTopology& topology;
  const CurvedSettings& settings;
  double height_mm;
  SignedDistance inside;
  std::vector<TriangleNumbers> lower;
  std::vector<TriangleNumbers> upper;
  double size_mm;
};

/// A scheme, its division of the part in height, and the surfaces its shells come from.
struct CurvedDivision {
  CurvedScheme scheme = CurvedScheme::BothSides;
  std::optional<double> lower_top_mm;  // nothing: lower shells go as high as the part
  double upper_bottom_mm = 0.0;
  TriangleNumbers lower;
  TriangleNumbers upper;
};

/// @throws Unsliceable if nothing faces down or up
/// @throws InvalidMesh if the mesh is open or holds no volume; InvalidConfig
CurvedPart curvedPart(const Mesh& mesh, const MeshTopology& topology, const CurvedSettings& settings,
                      double layer_height_mm);

/// The ways to divide a part, the one to be preferred first.
std::vector<CurvedDivision> curvedDivisions(const CurvedPart& part);

}  // namespace lamina
