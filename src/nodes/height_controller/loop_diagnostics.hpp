// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include "lamina/control/run/loop_run.hpp"
#include "loop/loop_feed.hpp"

namespace lamina {

/// Adds the outcome of clouds, of their points and of readings. The number of received clouds is the sum of
/// all other numbers of clouds except the placed ones; the number of received points is the sum of all other
/// numbers of points.
void addCounts(const FeedCounts& feed, const LoopCounts& loop,
               diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace lamina
