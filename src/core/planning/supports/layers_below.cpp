// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/layers_below.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kOnBed = 1e-3;          // layers: rounding of rotations
constexpr std::size_t kSpareLayers = 2;  // nothing stands in the first layer of all

}  // namespace

double heightAmid(const std::vector<Layer>& layers) { return layers[layers.size() / 2].bounds.height(); }

std::size_t countLayersBelow(const std::vector<Layer>& layers, const BedPlane& bed,
                             const SupportSettings& settings) {
  if (layers.empty()) return 0;
  const double first_mm = layers.front().bounds.bottom_mm;
  double lowest_mm = first_mm;
  for (const Layer& layer : layers)
    for (const Polygon& contour : layer.section.contours)
      for (const Point2& point : contour) {
        const double cut_mm = layer.bounds.cut();
        const double fall_mm = std::max(bed.heightOf({point.x(), point.y(), cut_mm}), 0.0);
        lowest_mm = std::min(lowest_mm, cut_mm - fall_mm * bed.up.z());
      }
  const double height_mm = heightAmid(layers);
  const double way = (first_mm - lowest_mm) / height_mm;
  if (way <= kOnBed) return 0;
  const double wider = settings.expand_mm * bed.up.head<2>().norm() / height_mm;
  return static_cast<std::size_t>(std::ceil(way + wider)) + kSpareLayers;
}

std::vector<Layer> withLayersBelow(const std::vector<Layer>& layers, std::size_t count) {
  if (count == 0) return layers;
  const double height_mm = heightAmid(layers);
  const double first_mm = layers.front().bounds.bottom_mm;
  std::vector<Layer> stack;
  stack.reserve(layers.size() + count);
  for (std::size_t i = count; i > 0; --i)
    stack.push_back(
        {{first_mm - static_cast<double>(i) * height_mm, first_mm - static_cast<double>(i - 1) * height_mm},
         {}});
  stack.insert(stack.end(), layers.begin(), layers.end());
  return stack;
}

}  // namespace lamina
