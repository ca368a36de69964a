// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Volume of what is deposited for the part, skirts left out [mm³] (eq. 4.6 of [Guacheta2021]). Drops
/// count by their own volume.
double estimatedVolume(const Toolpath& toolpath, const VolumeErrorSettings& settings);

/// Between that and the share of the part's volume that is asked for, without sign [mm³] (eq. 4.7 of
/// [Guacheta2021]).
double volumeError(const Toolpath& toolpath, double part_mm3, const VolumeErrorSettings& settings);

}  // namespace lamina
