// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Filament consumed per volume deposited [mm/mm³].
inline double filamentPerVolume(const ProgramSettings& settings) {
  const double radius = 0.5 * settings.filament_diameter_mm;
  return settings.flow / (M_PI * radius * radius);
}

/// Filament consumed by each motion of one path.
class PathExtrusion {
 public:
  PathExtrusion(const Path& path, double filament_per_volume)
      : path_(path),
        filament_per_volume_(path.role == PathRole::Travel ? 0.0 : filament_per_volume),
        common_(filament_per_volume_ * crossSection(path.bead.at(0))) {}

  /// Filament [mm] consumed by the motion of that length that ends at the waypoint.
  double along(double length_mm, std::size_t waypoint) const {
    if (path_.bead.isCommon()) return length_mm * common_;
    return length_mm * filament_per_volume_ * crossSection(path_.bead.at(waypoint));
  }

 private:
  const Path& path_;
  double filament_per_volume_;
  double common_;
};

}  // namespace lamina
