// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a contour is joined to the next one by two links.
enum class ContourLink {
  Tangential,  ///< each link goes to the nearest point of the next contour
  Average,     ///< both links run in the same direction, across the gap from which they start
};

/// Settings of the strategies of parallel contours.
struct ContourSettings {
  ContourLink link = ContourLink::Average;
  int seed = 1;  ///< seed of the random places where contours are cut
};

/// Adds the keys contour.*.
void describe(SettingsSchema& schema, ContourSettings& settings);

}  // namespace lamina
