// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// A mode, and why it suits a part as a sentence without full stop.
struct ModeChoice {
  std::string mode = "planar";
  std::string reason;
};

/// Whether the nozzle keeps its direction in the head at rest, or may be tilted.
enum class Nozzle { Held, Tilting };

/// The modes whose layers follow the part's skins, the best first. None if little of the surface slopes
/// between 1 and 45 deg from level, where level layers leave steps. A nozzle that may tilt gets curved
/// layers, provided that they do not begin in the air; one that keeps its direction gets layers that bend.
std::vector<ModeChoice> modesForSkins(const Mesh& mesh, const JobSettings& settings, Nozzle nozzle);

}  // namespace lamina
