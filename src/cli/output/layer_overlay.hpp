// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/job/voids/void_job.hpp"
#include "lamina/picture/toolpath_picture.hpp"

namespace lamina::cli {

/// Contour, voids and overfill of one layer, as they are drawn over its beads.
LayerOverlay overlayOf(const VoidReport& report, std::size_t layer);

}  // namespace lamina::cli
