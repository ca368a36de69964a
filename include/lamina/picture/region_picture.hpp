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

/// Draws the part in grey as a PNG, from the front right and 30 deg above, and beside it from the front left
/// and 30 deg below, the region in red. Where the part hides it, the region shines through.
/// @throws InvalidInput if part and region have no triangle; FileError
void drawRegion(const RegionPicture& picture, const std::string& png_path);

}  // namespace lamina
