// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a contour is joined to the next one.
enum class ContourLink {
  Tangential,  ///< each link goes to the nearest point of the next contour
  Average,     ///< both links go the same way, across the gap they start from
};

/// What the strategies of parallel contours ask for.
struct ContourSettings {
  ContourLink link = ContourLink::Average;
  int seed = 1;  ///< of the places where contours are cut
};

/// Adds the keys contour.*.
void describe(SettingsSchema& schema, ContourSettings& settings);

}  // namespace lamina
