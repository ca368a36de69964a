// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

enum class ImageFormat : std::uint8_t { Png, Qoi, Jpeg };

/// A small picture of what is deposited.
struct Thumbnail {
  int width_px = 0;
  int height_px = 0;
  ImageFormat format = ImageFormat::Png;
};

/// Thumbnails as `program.thumbnails` states them: "220x124 png, 16x16 qoi"; formats are png, qoi and jpg.
/// @throws InvalidConfig if a thumbnail is not of that form, or a side is not within 16 and 2000 pixels
std::vector<Thumbnail> thumbnailsFrom(const std::string& text);

/// The bytes of the picture's file: the part from the front right and 30 deg above, without skirt. Layers and
/// waypoints that would fall on the same pixels are left out, so that the time hardly depends on the part.
/// @throws InvalidInput if nothing is deposited
std::string drawThumbnail(const Toolpath& toolpath, const Thumbnail& thumbnail);

}  // namespace lamina
