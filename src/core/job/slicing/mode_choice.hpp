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

/// The modes to try for `slicing.mode: auto`, the best first; a base that is set must be laid on, else the
/// last one is planar, which refuses no part. What the settings already say decides first (a base, an
/// inclined plane, a lone wall); then how much of the part's surface slopes gently, between 1 and 45 deg from
/// level, where level layers leave steps; then whether the nozzle may tilt: a program for a machine with a
/// fixed head gets layers that bend, poses get curved ones.
std::vector<ModeChoice> modesFor(const Mesh& mesh, const SliceJob& job);

}  // namespace lamina
