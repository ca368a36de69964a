// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a part is cut into curved layers.
struct CurvedSettings {
  double normal_limit = 0.001;
  double longest_edge_mm = 1.0;
  double largest_gap_percent = 5.0;
  double largest_void_mm3 = 50.0;  ///< that hangs together; as far as samples show it (`LayerCoverage`)
};

void describe(SettingsSchema& schema, CurvedSettings& settings);

}  // namespace lamina
