// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/modes/mode_candidate.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// A part sliced by one mode.
struct ComparedMode {
  ModeCandidate candidate;
  Toolpath toolpath;  ///< in the part frame; empty if the mode refuses the part
  Mesh unsupported;   ///< triangles of the surface that overhangs its own layers by more than is taken
};

/// A part sliced by several modes.
struct ModeComparison {
  Mesh part;  ///< as it is deposited: larger than in its file where it shrinks
  std::vector<ComparedMode> modes;
  /// The one that `auto` takes. Nothing if all that it tries refuse the part, or one of those is not
  /// compared; nor where `conformal.base` or `auto.follow_skins` decide.
  std::optional<std::size_t> chosen;
};

/// The modes that are worth a comparison on a machine: level or inclined layers and those that bend for a
/// head that cannot tilt, and all that tilt it for others.
std::vector<std::string> comparableModes(const SliceJob& job);

/// Slices a part by several modes, one after the other, by the settings of the job and
/// `auto.max_overhang_deg`, prepared as for `auto`: on `conformal.base`, as large as it must be before it
/// shrinks. Nothing is written. What modes refuse stands in their candidates.
/// @throws InvalidConfig (no mode, one twice, one that there is not; settings), FileError, InvalidMesh
///   (of the file), Unreachable (larger than the machine, or a plane that its head cannot lay), Cancelled
ModeComparison compareModes(const SliceJob& job, const std::vector<std::string>& modes, Progress& progress);

}  // namespace lamina
