// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "program/rapid/writer/rapid_plan.hpp"

namespace lamina {

/// Where the wire stops ahead of the end of a run: on the way of a move, so far before its end.
struct RapidWireStop {
  RapidPlace move;
  double distance_mm = 0.0;
};

/// One for each run, in their order: where the tip passes `stop_s` before the run's end at the feeds of its
/// motions, or where the run begins if it is shorter than that. A controller acts at a distance however
/// briefly it brakes; at a time it acts while it brakes at the earliest.
std::vector<RapidWireStop> rapidWireStops(const std::vector<RapidPath>& paths, double stop_s);

}  // namespace lamina
