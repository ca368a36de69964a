// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstddef>

#include "lamina/picture/pixel_image.hpp"

namespace lamina {
namespace {

using Byte = std::uint8_t;

constexpr Byte kIndexTag = 0x00;
constexpr Byte kDifferenceTag = 0x40;
constexpr Byte kLumaTag = 0x80;
constexpr Byte kRunTag = 0xC0;
constexpr Byte kRgbTag = 0xFE;
constexpr int kLongestRun = 62;  // 63 and 64 would read as tags of whole colours

struct Pixel {
  Byte red = 0;
  Byte green = 0;
  Byte blue = 0;
  bool is_known = false;  ///< the decoder's table begins with pixels that are transparent, which none here is
};

bool isSame(const Pixel& a, const Pixel& b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

std::size_t slotOf(const Pixel& pixel) {
  constexpr int kOpaque = 255;
  return static_cast<std::size_t>(pixel.red * 3 + pixel.green * 5 + pixel.blue * 7 + kOpaque * 11) % 64;
}

class QoiWriter {
 public:
  explicit QoiWriter(std::string& bytes) : bytes_(bytes) {}

  void add(const Pixel& pixel) {
    if (isSame(pixel, last_)) {
      if (++run_ == kLongestRun) endRun();
      return;
    }
    endRun();
    Pixel& known = table_[slotOf(pixel)];
    if (known.is_known && isSame(known, pixel))
      put(static_cast<Byte>(kIndexTag | slotOf(pixel)));
    else
      addDifference(pixel);
    known = pixel;
    known.is_known = true;
    last_ = pixel;
  }

  void endRun() {
    if (run_ > 0) put(static_cast<Byte>(kRunTag | (run_ - 1)));
    run_ = 0;
  }

 private:
  void put(Byte byte) { bytes_ += static_cast<char>(byte); }

  /// Between -128 and 127, as bytes wrap round.
  static int wrapped(int difference) { return ((difference + 128) & 0xFF) - 128; }

  void addDifference(const Pixel& pixel) {
    const int red = wrapped(pixel.red - last_.red);
    const int green = wrapped(pixel.green - last_.green);
    const int blue = wrapped(pixel.blue - last_.blue);
    const auto isWithin = [](int value, int half) { return value >= -half && value < half; };
    if (isWithin(red, 2) && isWithin(green, 2) && isWithin(blue, 2)) {
      put(static_cast<Byte>(kDifferenceTag | (red + 2) << 4 | (green + 2) << 2 | (blue + 2)));
    } else if (isWithin(green, 32) && isWithin(red - green, 8) && isWithin(blue - green, 8)) {
      put(static_cast<Byte>(kLumaTag | (green + 32)));
      put(static_cast<Byte>((red - green + 8) << 4 | (blue - green + 8)));
    } else {
      for (const Byte byte : {kRgbTag, pixel.red, pixel.green, pixel.blue}) put(byte);
    }
  }

  std::string& bytes_;
  std::array<Pixel, 64> table_{};
  Pixel last_;
  int run_ = 0;
};

void putSize(std::string& bytes, int size) {
  for (const int shift : {24, 16, 8, 0})
    bytes += static_cast<char>(static_cast<unsigned>(size) >> shift & 0xFFU);
}

}  // namespace

std::string qoiFile(const PixelImage& image) {
  constexpr char kChannels = 3;
  constexpr char kLinearAlpha = 0;
  std::string bytes = "qoif";
  putSize(bytes, image.width);
  putSize(bytes, image.height);
  bytes += kChannels;
  bytes += kLinearAlpha;
  QoiWriter writer(bytes);
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    writer.add({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
  writer.endRun();
  return bytes + std::string(7, '\0') + '\x01';
}

}  // namespace lamina
