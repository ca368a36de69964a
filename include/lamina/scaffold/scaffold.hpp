// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/scaffold/scaffold_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The kinds by name: bending_specimen, box, cube, cylinder, sinusoidal.
std::vector<std::string> scaffoldNames();

/// One sentence on the kind.
/// @throws InvalidConfig if there is no such kind; names those there are
std::string scaffoldMeaning(const std::string& name);

/// The settings that a kind starts from: those of the specimens of [Vega2023, tables 1, 4 and 13,
/// section 7.2].
/// @throws InvalidConfig if there is no such kind; names those there are
ScaffoldSettings scaffoldDefaults(const std::string& name);

/// The part as a toolpath, on the bed, its low corner where the settings say. The number of layers is the one
/// that best matches the height; the nozzle runs at the top of each. Travels join the paths.
///
/// A sinusoidal scaffold of side L has layers of n filaments y_i(x) = A + i (L - 2 A) / (n - 1) + A f(2 pi B
/// x / L), x from 0 to L, i from 0 to n - 1, with amplitude A, B cycles, and f the sine or cosine. Layers are
/// turned about the middle by 90 deg from one to the next, or every two layers if sine and cosine alternate;
/// the first wave is `first_wave`. If filaments are mirrored, every other one has -A f. Unless `bead_fill` is
/// set, the cross-section of a bead is pi/4 of its width times height, and 0.98 of it if filaments are
/// mirrored: these factors reproduce the porosities of [Vega2023, tables 29 and 31].
///
/// Boxes, cubes, cylinders and specimens are filled inside their perimeters at the density asked for; a bead
/// is a stadium. Rectilinear lines are those of the infill strategy `zigzag`, rings those of `perimeters`;
/// solid layers of a gyroid are filled by lines. The period of the gyroid gives its curves, on average, the
/// length that the density requires.
///
/// @throws InvalidConfig naming key, value and bound, also if settings contradict each other: layers higher
///   than beads are wide, an amplitude above half the length, mirrored filaments other than sine waves, or a
///   shape without room for its beads; or if there is no such kind
Toolpath makeScaffold(const std::string& name, const ScaffoldSettings& settings);

}  // namespace lamina
