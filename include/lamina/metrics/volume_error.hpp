// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Volume deposited for the part, without skirts [mm³] (eq. 4.6 of [Guacheta2021]). Drops count with their
/// own volume.
double estimatedVolume(const Toolpath& toolpath, const VolumeErrorSettings& settings);

/// Absolute difference between the estimated volume and the share of the part's volume that should be filled
/// [mm³] (eq. 4.7 of [Guacheta2021]).
/// @param part_mm3  volume of the part
double volumeError(const Toolpath& toolpath, double part_mm3, const VolumeErrorSettings& settings);

}  // namespace lamina
