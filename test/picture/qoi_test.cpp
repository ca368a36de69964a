// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "lamina/picture/pixel_image.hpp"

namespace lamina {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// Pixels of a file, by the text of the specification [Szablewski2022].
std::vector<std::uint8_t> readQoi(const std::string& file, std::size_t pixels) {
  std::array<Pixel, 64> seen{};
  Pixel pixel = {0, 0, 0, 255};
  std::vector<std::uint8_t> rgb;
  std::size_t at = 14;
  const auto byte = [&] { return static_cast<std::uint8_t>(file.at(at++)); };
  int run = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (run > 0) {
      --run;
    } else if (const std::uint8_t tag = byte(); tag == 0xFE) {
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = byte();
    } else if (tag >> 6U == 0) {
      pixel = seen[tag];
    } else if (tag >> 6U == 1) {
      for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(pixel[c] + (tag >> (4 - 2 * c) & 3) - 2);
    } else if (tag >> 6U == 2) {
      const int green = (tag & 63) - 32;
      const std::uint8_t other = byte();
      pixel[0] = static_cast<std::uint8_t>(pixel[0] + green + (other >> 4) - 8);
      pixel[1] = static_cast<std::uint8_t>(pixel[1] + green);
      pixel[2] = static_cast<std::uint8_t>(pixel[2] + green + (other & 15) - 8);
    } else {
      run = tag & 63;
    }
    seen[static_cast<std::size_t>(pixel[0] * 3 + pixel[1] * 5 + pixel[2] * 7 + pixel[3] * 11) % 64] = pixel;
    rgb.insert(rgb.end(), pixel.begin(), pixel.begin() + 3);
  }
  EXPECT_EQ(run, 0);
  EXPECT_EQ(file.substr(at), std::string(7, '\0') + '\x01');
  return rgb;
}

TEST(Qoi, HasTheHeadOfTheFormat) {
  const std::string file = qoiFile({3, 2, std::vector<std::uint8_t>(18, 200)});
  EXPECT_EQ(file.substr(0, 14), std::string("qoif\0\0\0\3\0\0\0\2\3\0", 14));
  EXPECT_EQ(file.size(), 14U + 4U + 1U + 8U) << "one colour, a run of five more, the end";
}

RC_GTEST_PROP(Qoi, IsReadBackAsItWas, ()) {
  const auto colours =
      *rc::gen::resize(6, rc::gen::nonEmpty(rc::gen::arbitrary<std::vector<std::array<std::uint8_t, 3>>>()));
  const int width = *rc::gen::inRange(1, 90);
  PixelImage image{width, 4, {}};
  std::size_t index = 0;
  for (int i = 0; i < width * image.height; ++i) {
    if (*rc::gen::inRange(0, 4) == 0)
      index = static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(colours.size())));
    auto colour = colours[index];
    colour[1] = static_cast<std::uint8_t>(colour[1] + *rc::gen::inRange(0, 3));
    image.rgb.insert(image.rgb.end(), colour.begin(), colour.end());
  }
  RC_ASSERT(readQoi(qoiFile(image), static_cast<std::size_t>(width) * 4) == image.rgb);
}

}  // namespace
}  // namespace lamina
