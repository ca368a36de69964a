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
  bool may_be_glass = false;  ///< whether panels with `is_of_glass` draw it as glass
};

/// A view of a scene, in parallel projection.
struct ScenePanel {
  std::string title;
  double heading_rad = 0.0;    ///< angle of the direction from the centre to the viewer, about z from x
  double elevation_rad = 0.0;  ///< elevation of the viewer above the horizon; less than pi / 2
  Point3 centre = Point3::Zero();
  double span_mm = 1000.0;   ///< height of the part of the scene that is shown
  bool is_of_glass = false;  ///< whether solids that may be glass are drawn as glass, which hides nothing
};

/// A picture of a scene: its solids, and the panels that show them.
struct ScenePicture {
  std::string title;
  std::string subtitle;
  std::vector<SceneSolid> solids;
  std::vector<ScenePanel> panels;
};

/// Draws a scene as a PNG, its panels side by side, each at its own scale and with a scale bar on a white
/// plate.
/// @throws InvalidInput if there are no panels, or more than 4, or the span of one is not positive; FileError
void drawScene(const ScenePicture& picture, const std::string& png_path);

}  // namespace lamina
