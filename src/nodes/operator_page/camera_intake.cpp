// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera_intake.hpp"

#include <sensor_msgs/image_encodings.h>

#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/picture/pixel_image.hpp"

namespace lamina {
namespace {

constexpr double kInterval = 0.2;  // [s]
constexpr double kThere = 5.0;     // [s]

/// The layout of a pixel's bytes.
struct PixelLayout {
  std::size_t bytes = 0;  ///< 0: not one that is understood
  std::size_t red = 0;
  std::size_t green = 0;
  std::size_t blue = 0;
};

PixelLayout layoutOf(const std::string& encoding) {
  namespace encodings = sensor_msgs::image_encodings;
  if (encoding == encodings::RGB8) return {3, 0, 1, 2};
  if (encoding == encodings::BGR8) return {3, 2, 1, 0};
  if (encoding == encodings::RGBA8) return {4, 0, 1, 2};
  if (encoding == encodings::BGRA8) return {4, 2, 1, 0};
  if (encoding == encodings::MONO8) return {1, 0, 0, 0};
  return {};
}

PixelImage pixelsOf(const sensor_msgs::Image& image) {
  const PixelLayout layout = layoutOf(image.encoding);
  const std::size_t row_bytes = image.width * layout.bytes;
  if (layout.bytes == 0)
    throw InvalidInput("an image of the camera is encoded as '" + image.encoding +
                       "'; expected rgb8, bgr8, rgba8, bgra8 or mono8");
  if (image.step < row_bytes || image.data.size() / std::max<std::size_t>(image.step, 1) < image.height)
    throw InvalidInput("an image of the camera has " + std::to_string(image.data.size()) +
                       " bytes; expected " + std::to_string(std::size_t{image.step} * image.height));
  PixelImage pixels{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  pixels.rgb.reserve(std::size_t{image.width} * image.height * 3);
  for (std::size_t row = 0; row < image.height; ++row)
    for (std::size_t column = 0; column < image.width; ++column) {
      const std::uint8_t* pixel = image.data.data() + row * image.step + column * layout.bytes;
      pixels.rgb.insert(pixels.rgb.end(), {pixel[layout.red], pixel[layout.green], pixel[layout.blue]});
    }
  return pixels;
}

}  // namespace

CameraIntake::CameraIntake(ros::NodeHandle node, const std::string& topic,
                           std::function<void(std::string jpeg)> take)
    : take_(std::move(take)),
      compressed_(node.subscribe(topic + "/compressed", 1, &CameraIntake::onCompressed, this)),
      raw_(node.subscribe(topic, 1, &CameraIntake::onRaw, this)) {}

bool CameraIntake::isThere() const { return taken_s_ && clock_.now() - *taken_s_ < kThere; }

bool CameraIntake::isDue() {
  const double now_s = clock_.now();
  if (taken_s_ && now_s - *taken_s_ < kInterval) return false;
  taken_s_ = now_s;
  return true;
}

void CameraIntake::onCompressed(const sensor_msgs::CompressedImageConstPtr& image) {
  constexpr std::uint8_t kJpegStart = 0xff;  // of the first two bytes of a JPEG file, FF D8
  if (image->data.size() < 2 || image->data[0] != kJpegStart) {
    ROS_WARN_STREAM_THROTTLE(60.0,
                             "a compressed image of the camera is '" << image->format << "'; expected JPEG");
    return;
  }
  if (!isDue()) return;
  compressed_taken_s_ = taken_s_;
  take_(std::string(image->data.begin(), image->data.end()));
}

void CameraIntake::onRaw(const sensor_msgs::ImageConstPtr& image) {
  const bool is_compressed = compressed_taken_s_ && clock_.now() - *compressed_taken_s_ < kThere;
  if (is_compressed || !isDue()) return;
  try {
    take_(jpegFile(pixelsOf(*image)));
  } catch (const Error& error) {
    ROS_WARN_STREAM_THROTTLE(60.0, error.what());
  }
}

}  // namespace lamina
