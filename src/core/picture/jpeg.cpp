// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/module.hpp"
#include "lamina/picture/pixel_image.hpp"
#include "picture/jpeg_module.hpp"

namespace lamina {

std::string jpegFile(const PixelImage& image) {
  return static_cast<const JpegModule*>(moduleTable("jpeg"))->encode(image);
}

}  // namespace lamina
