// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cairo.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "lamina/picture/colour.hpp"

namespace lamina::test {

/// A picture read from a file, pixel by pixel.
class PngImage {
 public:
  explicit PngImage(const std::string& path) : surface_(cairo_image_surface_create_from_png(path.c_str())) {
    if (cairo_surface_status(surface_) != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error("no picture: " + path);
  }
  ~PngImage() { cairo_surface_destroy(surface_); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;

  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }
  /// Column from the left, row from the top.
  Colour at(int column, int row) const {
    const unsigned char* bytes = cairo_image_surface_get_data(surface_);
    std::uint32_t pixel = 0;
    std::memcpy(
        &pixel,
        bytes + std::ptrdiff_t{row} * cairo_image_surface_get_stride(surface_) + std::ptrdiff_t{4} * column,
        sizeof pixel);
    return {(pixel >> 16 & 255U) / 255.0, (pixel >> 8 & 255U) / 255.0, (pixel & 255U) / 255.0};
  }

 private:
  cairo_surface_t* surface_;
};

}  // namespace lamina::test
