// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "program/rapid/writer/rapid_plan.hpp"

namespace lamina {

/// Place at which the wire stops before the end of a run: a distance before the end of a move.
struct RapidWireStop {
  RapidPlace move;
  double distance_mm = 0.0;
};

/// The wire stop of each run, in order: the place that the tip passes `stop_s` before the run's end at the
/// feeds of its motions, or the start of a shorter run. Stops are distances, as a controller acts at a
/// distance however briefly it brakes; a stop by time would take effect while braking at the earliest.
std::vector<RapidWireStop> rapidWireStops(const std::vector<RapidPath>& paths, double stop_s);

}  // namespace lamina
