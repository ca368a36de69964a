// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing/shown_layers.hpp"

#include <algorithm>

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Points of a chunk that belong to the first layers of the part.
std::size_t pointsWithin(const MarkerChunk& chunk, std::size_t layers) {
  if (layers <= chunk.first_layer || chunk.points_up_to.empty()) return 0;
  const std::size_t last = std::min(layers - chunk.first_layer, chunk.points_up_to.size()) - 1;
  return chunk.points_up_to[last];
}

/// A marker with the first of its points; one that deletes it if there are none.
Marker firstPoints(const Marker& whole, std::size_t points) {
  Marker marker;
  marker.header = whole.header;
  marker.ns = whole.ns;
  marker.id = whole.id;
  marker.type = whole.type;
  marker.action = points > 0 ? Marker::ADD : Marker::DELETE;
  marker.pose = whole.pose;
  marker.scale = whole.scale;
  marker.color = whole.color;
  marker.points.assign(whole.points.begin(), whole.points.begin() + static_cast<std::ptrdiff_t>(points));
  return marker;
}

}  // namespace

void ShownLayers::load(std::vector<MarkerChunk> chunks, std::size_t layers) {
  shown_.clear();
  shown_.reserve(chunks.size());
  for (MarkerChunk& chunk : chunks) {
    const std::size_t points = chunk.marker.points.size();
    shown_.push_back({std::move(chunk), points});
  }
  layers_ = layers;
}

void ShownLayers::moveTo(const geometry_msgs::Point& position) {
  for (Shown& shown : shown_) shown.chunk.marker.pose.position = position;
}

MarkerArray ShownLayers::all() const {
  MarkerArray markers;
  Marker clear;
  clear.action = Marker::DELETEALL;
  if (!shown_.empty()) clear.header.frame_id = shown_.front().chunk.marker.header.frame_id;
  markers.markers.push_back(clear);
  for (const Shown& shown : shown_)
    if (shown.points > 0) markers.markers.push_back(firstPoints(shown.chunk.marker, shown.points));
  return markers;
}

MarkerArray ShownLayers::show(std::size_t layers) {
  MarkerArray changes;
  for (Shown& shown : shown_) {
    const std::size_t points = pointsWithin(shown.chunk, layers);
    if (points == shown.points) continue;
    shown.points = points;
    changes.markers.push_back(firstPoints(shown.chunk.marker, points));
  }
  return changes;
}

}  // namespace lamina
