// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/picture/colour.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

enum class PictureView {
  Oblique,  ///< from the front right and 30 deg above, without perspective
  Top,
};

enum class PictureColour { Role, Height };

struct ToolpathPictureSettings {
  PictureView view = PictureView::Oblique;
  PictureColour colour = PictureColour::Role;
  int width_px = 1400;
  int height_px = 1050;
};

/// The colour of a role in all pictures.
Colour roleColour(PathRole role);

/// Draws all that is deposited, with title, scale bar and legend, over a grid of 10 mm (50 mm for parts above
/// 300 mm). Beads are drawn at their true width, and hide those below them.
/// @throws InvalidInput if nothing is deposited, or the size is out of bounds; FileError
void drawToolpath(const Toolpath& toolpath, const ToolpathPictureSettings& settings,
                  const std::string& png_path);

/// What is drawn over the beads of a layer.
struct LayerOverlay {
  Regions contour;                ///< area that the layer should fill; its outline is drawn
  std::vector<Region> voids;      ///< filled with red
  std::vector<Region> overfills;  ///< filled with dark blue
  std::string remark;             ///< drawn below the title
};

/// Draws one layer from above: beads at their true width, drops as discs, travels as thin dashed lines, path
/// starts as dots.
/// @throws InvalidInput if there is no such layer, or it has no path; FileError
void drawToolpathLayer(const Toolpath& toolpath, std::size_t layer, const ToolpathPictureSettings& settings,
                       const std::string& png_path);

/// Draws one layer likewise, with contour, voids and overfills over it.
void drawToolpathLayer(const Toolpath& toolpath, std::size_t layer, const LayerOverlay& overlay,
                       const ToolpathPictureSettings& settings, const std::string& png_path);

}  // namespace lamina
