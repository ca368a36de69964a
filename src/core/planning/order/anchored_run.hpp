// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// The run as it is deposited so that it begins where it is carried. One that does so stays as it is, and so
/// do drops, which hang on nothing. A closed run starts at the beginning of its longest carried stretch, so
/// that what hangs over is deposited last, between ends that hold. An open run is turned round if its other
/// end is carried; otherwise it is parted amid its longest carried stretch and both parts begin there. A run
/// that nothing carries stays as it is.
/// @param carries  whether something lies below a point of the run
/// @return one run, or two
std::vector<FillPath> anchored(FillPath run, const std::function<bool(const Point2&)>& carries);

}  // namespace lamina
