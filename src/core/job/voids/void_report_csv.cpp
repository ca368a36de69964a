// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/void_report_csv.hpp"

#include <algorithm>
#include <cstdio>

#include "lamina/base/atomic_file.hpp"

namespace lamina {

std::string voidCsv(const std::vector<LayerVoids>& layers) {
  std::string text = "layer,z_mm,area_mm2,deposited_mm2,uncovered_mm2,overfill_mm2,runs,voids";
  for (const VoidClass kind : kVoidClasses) text += std::string(",") + toString(kind);
  text += "\n";
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const LayerVoids& layer = layers[i];
    char line[256];
    std::snprintf(line, sizeof line, "%zu,%.4f,%.4f,%.4f,%.4f,%.4f,%zu,%zu", i, layer.z_mm, layer.area_mm2,
                  layer.deposited_mm2, layer.uncovered_mm2, layer.overfill_mm2, layer.runs,
                  layer.voids.size());
    text += line;
    for (const VoidClass kind : kVoidClasses)
      text += "," + std::to_string(std::count_if(layer.voids.begin(), layer.voids.end(),
                                                 [&](const Void& each) { return each.kind == kind; }));
    text += "\n";
  }
  return text;
}

void writeVoidCsv(const std::string& path, const std::vector<LayerVoids>& layers) {
  writeFile(path, voidCsv(layers));
}

}  // namespace lamina
