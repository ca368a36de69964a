// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
//
#include <jpeglib.h>

#include "lamina/picture/pixel_image.hpp"

namespace lamina {
namespace {

/// What any decoder makes of it.
PixelImage decodedJpeg(const std::string& bytes) {
  jpeg_decompress_struct library{};
  jpeg_error_mgr errors{};
  library.err = jpeg_std_error(&errors);
  jpeg_create_decompress(&library);
  jpeg_mem_src(&library, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&library, TRUE);
  library.out_color_space = JCS_RGB;
  jpeg_start_decompress(&library);
  PixelImage image{static_cast<int>(library.output_width), static_cast<int>(library.output_height), {}};
  image.rgb.resize(3 * std::size_t(library.output_width) * library.output_height);
  while (library.output_scanline < library.output_height) {
    unsigned char* row = &image.rgb[3 * std::size_t(library.output_width) * library.output_scanline];
    jpeg_read_scanlines(&library, &row, 1);
  }
  jpeg_finish_decompress(&library);
  jpeg_destroy_decompress(&library);
  return image;
}

/// Red to the left, blue to the right, with green that grows downwards.
PixelImage halves(int width, int height) {
  PixelImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool is_left = x < width / 2;
      const auto green = static_cast<std::uint8_t>(255 * y / height);
      for (const std::uint8_t value :
           {std::uint8_t(is_left ? 200 : 20), green, std::uint8_t(is_left ? 20 : 200)})
        image.rgb.push_back(value);
    }
  return image;
}

TEST(Jpeg, KeepsSizeAndColours) {
  for (const auto& [width, height] : {std::pair(220, 124), std::pair(17, 16), std::pair(16, 33)}) {
    const PixelImage drawn = halves(width, height);
    const PixelImage seen = decodedJpeg(jpegFile(drawn));
    ASSERT_EQ(seen.width, width);
    ASSERT_EQ(seen.height, height);
    double difference = 0.0;
    for (std::size_t i = 0; i < drawn.rgb.size(); ++i)
      difference += std::abs(int(drawn.rgb[i]) - int(seen.rgb[i]));
    EXPECT_LT(difference / double(drawn.rgb.size()), 6.0) << width;
  }
}

TEST(Jpeg, IsTheSameBytesEachTime) {
  const PixelImage drawn = halves(64, 48);
  const std::string bytes = jpegFile(drawn);
  EXPECT_EQ(bytes, jpegFile(drawn));
  EXPECT_EQ(bytes.substr(0, 3), "\xFF\xD8\xFF");
  EXPECT_EQ(bytes.substr(bytes.size() - 2), "\xFF\xD9");
}

}  // namespace
}  // namespace lamina
