// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/picture/pixel_image.hpp"

namespace lamina {

/// Functions of the module `jpeg`, which keeps libjpeg out of commands that write no JPEG.
struct JpegModule {
  std::string (*encode)(const PixelImage& image);  ///< as `jpegFile`
};

}  // namespace lamina
