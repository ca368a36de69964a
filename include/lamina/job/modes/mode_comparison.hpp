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
  Toolpath toolpath;  ///< [part frame]; empty if the mode cannot slice the part
  Mesh unsupported;  ///< triangles of the surface that overhang the mode's own layers by more than is allowed
};

/// A part sliced by several modes.
struct ModeComparison {
  Mesh part;  ///< as it is deposited: larger than in its file if shrinkage is compensated
  std::vector<ComparedMode> modes;
  /// Index of the mode that `auto` would choose. Nothing if it would find none, if it would try a mode that
  /// is not among these, or if `conformal.base` or `auto.follow_skins` decide.
  std::optional<std::size_t> chosen;
};

/// The modes worth comparing on a machine: `inclined` alone if the head is inclined or the job's plane is;
/// otherwise those that `auto` tries on it, and `heightfield` if the head cannot tilt, or `curved` if it can.
std::vector<std::string> comparableModes(const SliceJob& job);

/// Slices a part by several modes, one after the other, by the settings of the job and
/// `auto.max_overhang_deg`. The part is prepared as for `auto`: deposited on `conformal.base` if that is set,
/// and enlarged to compensate shrinkage. Nothing is written. If a mode cannot slice the part, its candidate
/// states why.
/// @throws InvalidConfig if no mode is given, one is given twice, one does not exist, or settings are invalid
/// @throws FileError, InvalidMesh for the part's file
/// @throws Unreachable if the part is larger than the machine, or its head cannot print the plane
/// @throws Cancelled
ModeComparison compareModes(const SliceJob& job, const std::vector<std::string>& modes, Progress& progress);

}  // namespace lamina
