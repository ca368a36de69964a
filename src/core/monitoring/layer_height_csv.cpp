// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/layer_height_csv.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

namespace lamina {

std::string layerHeightCsv(const std::vector<LayerHeightReport>& layers) {
  std::ostringstream csv;
  csv.imbue(std::locale::classic());
  csv << "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells,profiles,sight\n"
      << std::setprecision(9);
  for (const LayerHeightReport& layer : layers) {
    const HeightStatistics& of = layer.statistics;
    csv << layer.layer << ',' << layer.expected_height_mm << ',';
    if (layer.sight == LayerSight::NotSeen)
      csv << ",,";
    else
      csv << of.mean_mm << ',' << of.rms_mm << ',' << of.worst_mm;
    csv << ',' << of.coverage << ',' << of.cells << ',' << layer.profiles << ',' << toString(layer.sight)
        << '\n';
  }
  return csv.str();
}

}  // namespace lamina
