// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/void_json.hpp"

#include "lamina/base/atomic_file.hpp"

namespace lamina::cli {
namespace {

nlohmann::ordered_json toJson(const Polygon& polygon) {
  nlohmann::ordered_json points = nlohmann::json::array();
  for (const Point2& point : polygon) points.push_back({point.x(), point.y()});
  return points;
}

nlohmann::ordered_json toJson(const Void& found) {
  nlohmann::ordered_json holes = nlohmann::json::array();
  for (const Polygon& hole : found.outline.holes) holes.push_back(toJson(hole));
  return {{"class", toString(found.kind)},
          {"area_mm2", found.area_mm2},
          {"outline_mm", toJson(found.outline.outer)},
          {"holes_mm", holes}};
}

}  // namespace

nlohmann::ordered_json layerToJson(const LayerVoids& layer, std::size_t index) {
  nlohmann::ordered_json voids = nlohmann::json::array();
  for (const Void& each : layer.voids) voids.push_back(toJson(each));
  return {{"layer", index},
          {"z_mm", layer.z_mm},
          {"area_mm2", layer.area_mm2},
          {"deposited_mm2", layer.deposited_mm2},
          {"uncovered_mm2", layer.uncovered_mm2},
          {"overfill_mm2", layer.overfill_mm2},
          {"runs", layer.runs},
          {"voids", voids}};
}

void writeVoidJson(const std::string& path, const std::vector<LayerVoids>& layers) {
  AtomicFile file(path);
  file.write("{\"layers\": [\n");
  for (std::size_t i = 0; i < layers.size(); ++i)
    file.write(layerToJson(layers[i], i).dump() + (i + 1 < layers.size() ? ",\n" : "\n"));
  file.write("]}\n");
  file.commit();
}

}  // namespace lamina::cli
