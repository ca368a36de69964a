// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// A mode and why it suits a part, a sentence without full stop.
struct ModeChoice {
  std::string mode = "planar";
  std::string reason;
};

/// Whether the nozzle stays as the head holds it, or may be tilted.
enum class Nozzle { Held, Tilting };

/// The modes whose layers follow the part's skins, the best first; none if little of its surface slopes
/// gently, between 1 and 45 deg from level, where level layers leave steps. A nozzle that may tilt gets
/// curved layers, if they do not begin in the air; one that is held gets layers that bend.
std::vector<ModeChoice> modesForSkins(const Mesh& mesh, const JobSettings& settings, Nozzle nozzle);

}  // namespace lamina
