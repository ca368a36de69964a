// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/monitoring/height_monitor.hpp"

namespace lamina {

/// One row a layer under the header
/// `layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells,profiles,sight`; the
/// errors of a layer that was not seen are empty cells.
std::string layerHeightCsv(const std::vector<LayerHeightReport>& layers);

}  // namespace lamina
