// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Changes a run so that it begins at a supported point. A run that does so already stays as it is, and so do
/// drops and a run without support. A closed run starts at the beginning of its longest supported stretch, so
/// that the unsupported rest is deposited last, between supported ends. An open run is reversed if its other
/// end is supported; otherwise it is divided in the middle of its longest supported stretch, where both parts
/// begin.
/// @param carries  whether a point of the run is supported
/// @return one run, or two
std::vector<FillPath> anchored(FillPath run, const std::function<bool(const Point2&)>& carries);

/// An open run of beads without support, reversed if its other end is nearer to beads of the part.
/// @param deposited  paths of the same layer; without beads of the part the run stays as it is
FillPath begunAtBeads(FillPath run, const std::vector<Path>& deposited);

}  // namespace lamina
