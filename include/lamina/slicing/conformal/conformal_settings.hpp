// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How layers are deposited on a given surface.
struct ConformalSettings {
  std::string base;  ///< mesh file that the layers of a part are deposited on; empty to coat the part
  double max_tilt_deg = 60.0;     ///< of a face from the direction
  std::vector<double> direction;  ///< where the faces look that are deposited on; empty is up
  double thickness_mm = 1.0;      ///< of a coat
  double longest_edge_mm = 1.0;
  double largest_gap_percent = 5.0;
};

void describe(SettingsSchema& schema, ConformalSettings& settings);

}  // namespace lamina
