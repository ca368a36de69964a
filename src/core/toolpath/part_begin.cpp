// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath/part_begin.hpp"

namespace lamina {

bool beginsPart(const std::vector<ToolpathLayer>& layers, std::size_t index) {
  constexpr double kLevel = 1e-6;  // mm
  if (index == 0) return true;
  const ToolpathLayer& layer = layers[index];
  const double bed_mm = layers.front().z_mm - layers.front().height_mm;
  return layer.z_mm < layers[index - 1].z_mm && layer.z_mm - layer.height_mm <= bed_mm + kLevel;
}

}  // namespace lamina
