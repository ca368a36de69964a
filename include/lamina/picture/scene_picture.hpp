// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/picture/colour.hpp"

namespace lamina {

/// A solid in a scene, in one colour.
struct SceneSolid {
  Mesh mesh;  ///< [mm, frame of the scene, z up]; faces are seen from outside only
  Colour colour;
  bool may_be_glass = false;  ///< seen through in panels of glass
};

/// A view of a scene, in parallel projection.
struct ScenePanel {
  std::string title;
  double heading_rad = 0.0;    ///< direction from the centre to the viewer, about z from x
  double elevation_rad = 0.0;  ///< of the viewer over the horizon; less than pi / 2
  Point3 centre = Point3::Zero();
  double span_mm = 1000.0;   ///< height of the part of the scene that is shown
  bool is_of_glass = false;  ///< solids that may be glass hide nothing
};

struct ScenePicture {
  std::string title;
  std::string subtitle;
  std::vector<SceneSolid> solids;
  std::vector<ScenePanel> panels;
};

/// Draws a scene as a PNG, its panels side by side at scales of their own, each with a scale bar that stands
/// out from whatever is behind it.
/// @throws InvalidInput if there are no panels, or more than 4, or one shows nothing; FileError
void drawScene(const ScenePicture& picture, const std::string& png_path);

}  // namespace lamina
