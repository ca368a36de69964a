// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A part in the layers of one mode.
struct ModePanel {
  std::string mode;
  std::string remark;                ///< beside its name, in green; empty for none
  std::string refusal;               ///< why there are no layers; empty if there are
  std::vector<std::string> figures;  ///< below the pictures, a line each
  const Toolpath& toolpath;          ///< in the frame of the part; empty if refused
  const Mesh& unsupported;           ///< unsupported triangles of the part's surface
};

/// Modes side by side.
struct ModePicture {
  std::string title;
  std::string subtitle;
  const Mesh& part;
  std::vector<ModePanel> panels;
};

/// Draws each panel's part as a PNG in two views: the upper one from the front right and above, the lower one
/// from the front left and below. The surface shows the layers as bands, as the nearest outer wall has them,
/// dark where it is printed first and light where it is printed last. Unsupported triangles are red, and
/// shine through where the part hides them. A part that the mode refuses is grey.
/// @throws InvalidInput if the part has no triangle, or there are no panels, or more than 12; FileError
void drawModes(const ModePicture& picture, const std::string& png_path);

}  // namespace lamina
