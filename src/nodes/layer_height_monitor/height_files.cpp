// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "height_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "conversions.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/monitoring/layer_height_csv.hpp"
#include "lamina/monitoring/octree_export.hpp"
#include "lamina/picture/height_map_picture.hpp"

namespace lamina {
namespace {

std::string summaryOf(const HeightMonitor& monitor, const std::vector<LayerHeightReport>& layers) {
  std::ostringstream text;
  const auto is_seen = [](const LayerHeightReport& layer) { return layer.sight != LayerSight::NotSeen; };
  const auto seen = std::count_if(layers.begin(), layers.end(), is_seen);
  text << seen << " of " << monitor.toolpath().layers.size() << " layers measured";
  const auto last = std::find_if(layers.rbegin(), layers.rend(), is_seen);
  if (last != layers.rend())
    text << std::fixed << std::setprecision(3) << "; layer " << last->layer << ": mean error "
         << last->statistics.mean_mm << " mm, worst " << last->statistics.worst_mm << " mm";
  return text.str();
}

}  // namespace

void saveHeights(const std::string& folder, const HeightMonitor& monitor,
                 const std::vector<LayerHeightReport>& layers) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw FileError("cannot make the folder " + folder + ": " + failure.message());
  const std::string part = monitor.toolpath().part_name;
  const std::string summary = summaryOf(monitor, layers);
  const HeightMap heights = monitor.measured().heights();
  drawHeightMap(folder + "/height_map.png", heights, {"Measured height: " + part, summary});
  drawDeviation(folder + "/deviation.png", monitor.deviation(),
                {"Measured less expected height: " + part, summary});
  writeOctree(folder + "/height_map.bt", *octreeOf(heights, kMetresPerMillimetre, monitor.bedFromHeights()));
  writeFile(folder + "/layer_heights.csv", layerHeightCsv(layers));
}

}  // namespace lamina
