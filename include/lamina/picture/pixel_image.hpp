// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lamina {

/// A picture by its pixels, row by row from the top.
struct PixelImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< red, green and blue of each, 3 * width * height
};

/// The bytes of a QOI file, three channels, sRGB [Szablewski2022].
std::string qoiFile(const PixelImage& image);

/// The bytes of a JPEG file [ITUT81], baseline, of quality 90; colours are sampled at half the size.
/// @throws FileError if the library for JPEG cannot be loaded; InvalidInput for pictures that the format
///   cannot hold
std::string jpegFile(const PixelImage& image);

}  // namespace lamina
