// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Feed of a role in a layer [mm/s]; at most `feed.first_layer_mm_s` in layer 0.
double feedIn(const FeedSettings& feed, PathRole role, std::size_t layer);

}  // namespace lamina
