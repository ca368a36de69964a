// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A part and the region of its surface that stands in the way of something.
struct RegionPicture {
  std::string title;
  std::string reason;  ///< below the title, as many lines as it needs
  const Mesh& part;
  const Mesh& region;
};

/// Draws the part in grey and the region in red as a PNG, in two views side by side: from the front right, 30
/// deg above, and from the front left, 30 deg below. Where the part hides the region, the region shines
/// through.
/// @throws InvalidInput if neither part nor region has a triangle
/// @throws FileError if the picture cannot be written
void drawRegion(const RegionPicture& picture, const std::string& png_path);

}  // namespace lamina
