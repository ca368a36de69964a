// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/deviation_markers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "conversions.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kFullShare = 0.25;  // of the layer's height
constexpr float kOther = 0.12F;      // of the other two colours where one is full
constexpr double kTextAboveLayers = 3.0;
constexpr double kLeastText = 0.5;  // mm
constexpr double kTextShare =
    0.05;  // height of the letters over the extent of the layer: its lines are as long
constexpr double kFromLineToLine = 1.6;  // from line to line over the height of the letters

std_msgs::ColorRGBA grey(float level) {
  std_msgs::ColorRGBA colour;
  colour.r = colour.g = colour.b = level;
  colour.a = 1.0F;
  return colour;
}

Marker newMarker(const char* name, const std::string& frame) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = name;
  marker.pose.orientation.w = 1.0;
  marker.frame_locked = 1U;
  return marker;
}

/// From the top to the bottom.
std::vector<std::string> scaleLines(const LayerFigures& figures, std::size_t number, double full_mm) {
  char of_layer[120];
  std::snprintf(of_layer, sizeof of_layer, "layer %zu: off by %.3f mm (rms), %+.3f mm in the mean", number,
                figures.rmse_mm, -figures.mean_error_mm);
  char of_colours[80];
  std::snprintf(of_colours, sizeof of_colours, "red: %.2f mm too high, blue: too low, grey: not seen",
                full_mm);
  return {of_layer, of_colours};
}

/// A marker for each line: RViz sets the lines of one text a centimetre apart, however small its letters are.
void addScale(MarkerArray& all, const LayerOutcome& layer, const std::vector<std::string>& lines,
              const Eigen::Isometry3d& frame_from_part) {
  Point3 low = frame_from_part * layer.cells.front().at;
  Point3 high = low;
  for (const CellOutcome& cell : layer.cells) {
    const Point3 at = frame_from_part * cell.at;
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const double letter_mm = std::max(kLeastText, kTextShare * (high - low).norm());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto lines_below = static_cast<double>(lines.size() - 1 - i);
    Point3 place = 0.5 * (low + high);
    place.z() =
        high.z() + kTextAboveLayers * layer.figures.height_mm + kFromLineToLine * letter_mm * lines_below;
    Marker text = newMarker("scale", all.markers.front().header.frame_id);
    text.id = static_cast<std::int32_t>(i);
    text.type = Marker::TEXT_VIEW_FACING;
    text.pose.position = toMessage(place);
    text.scale.z = toMetres(letter_mm);
    text.color = grey(0.1F);
    text.text = lines[i];
    all.markers.push_back(std::move(text));
  }
}

}  // namespace

std_msgs::ColorRGBA deviationColour(double deviation_mm, double full_mm) {
  const auto share = static_cast<float>(std::min(1.0, std::abs(deviation_mm) / full_mm));
  const float other = 1.0F - (1.0F - kOther) * share;
  std_msgs::ColorRGBA colour = grey(other);
  (deviation_mm > 0.0 ? colour.r : colour.b) = 1.0F;
  return colour;
}

MarkerArray deviationMarkers(const LayerOutcome& layer, std::size_t layers_below, const std::string& frame,
                             const Eigen::Isometry3d& frame_from_part) {
  MarkerArray all;
  if (layer.cells.empty()) return all;
  const double full_mm = kFullShare * layer.figures.height_mm;
  const std::size_t number = layers_below + layer.figures.layer;
  Marker beads = newMarker("beads", frame);
  beads.id = static_cast<std::int32_t>(number);
  beads.type = Marker::LINE_LIST;
  beads.color = grey(1.0F);
  double width_mm = 0.0;
  for (const CellOutcome& cell : layer.cells) {
    const std_msgs::ColorRGBA colour = cell.is_seen ? deviationColour(-cell.error_mm, full_mm) : grey(0.55F);
    for (const double side : {-0.5, 0.5}) {
      beads.points.push_back(toMessage(Point3(frame_from_part * (cell.at + side * cell.along_mm))));
      beads.colors.push_back(colour);
    }
    width_mm += cell.width_mm / static_cast<double>(layer.cells.size());
  }
  beads.scale.x = toMetres(width_mm);
  all.markers.push_back(std::move(beads));
  addScale(all, layer, scaleLines(layer.figures, number, full_mm), frame_from_part);
  return all;
}

MarkerArray noDeviationMarkers(const std::string& frame) {
  MarkerArray all;
  all.markers.push_back(newMarker("beads", frame));
  all.markers.back().action = Marker::DELETEALL;
  return all;
}

}  // namespace lamina
