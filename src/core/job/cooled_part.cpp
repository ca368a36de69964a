// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/cooled_part.hpp"

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/kinematics/model/toolpath_reach.hpp"
#include "lamina/planning/cooling/cooling.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "planning/cooling/parking.hpp"

namespace lamina {
namespace {

/// What an output can hold of cooling.
struct CarriedCooling {
  bool waits = true;
  bool fan = true;
  std::string by;  ///< the output, for notes
};

CarriedCooling carriedBy(const SliceJob& job) {
  const std::string suffix = std::filesystem::path(job.output).extension().string();
  if (isRobotFile(job.output)) return {false, false, robotLanguageName(job.output)};
  if (suffix != ".gcode") return {};
  const std::string& name = job.settings.program.dialect;
  const GcodeDialect dialect = gcodeDialects().find(name);
  return {dialect.has_waits, dialect.has_fan, "G-code of dialect '" + name + "'"};
}

/// Where a job is run.
struct JobSite {
  const BuildSpace& space;
  const MotionLimits& limits;
};

/// Whether the nozzle reaches all places where it may be asked to wait beside the part.
bool canPark(const SlicedPart& sliced, const CoolingSettings& cooling, const BuildSpace& space) {
  const Box3 part = depositionBox(sliced.toolpath);
  if (part.isEmpty()) return true;
  const Point3 up = layerNormal(sliced.toolpath);
  const Point3 lift = cooling.lift_mm * up;
  Path places;
  places.role = PathRole::Travel;
  for (const double x : {part.low.x(), part.high.x()})
    for (const double y : {part.low.y(), part.high.y()})
      for (const double z : {part.low.z(), part.high.z()})
        places.points.push_back(parkingPlace({x, y, z}, part, cooling.park, up) + lift);
  Toolpath waits;
  waits.layers = {{part.high.z(), 1.0, {std::move(places)}}};
  try {
    requireTipsReachable(waits, sliced.bed_from_part, space);
  } catch (const Unreachable&) {
    return false;
  }
  return true;
}

void giveTimes(SlicedPart& sliced, CoolingSettings cooling, const JobSite& site, Progress& progress) {
  const bool waits_elsewhere = cooling.least_layer_time_s > 0.0 && cooling.park != ParkPlace::Stay;
  if (waits_elsewhere) cooling = reachableParking(sliced, cooling, site.space);
  const bool has_room = !waits_elsewhere || cooling.park != ParkPlace::Stay;
  const CoolingSummary summary = cool(sliced.toolpath, cooling, site.limits, progress);
  const auto note = [&sliced](std::size_t count, const std::string& what) {
    if (count > 0) sliced.summary.notes.push_back(std::to_string(count) + " layers " + what);
  };
  note(summary.slowed_layers, "are slowed down to take their least time");
  if (summary.dwells > 0) {
    const bool are_places = cooling.interval == CoolingInterval::Place;
    char waiting[160];
    std::snprintf(waiting, sizeof waiting, "%zu %s end with a dwell, %.1f s in all%s", summary.dwells,
                  are_places ? "islands of layers" : "layers", summary.dwell_s,
                  has_room ? "" : ", over where they end: cooling.park is out of the machine's reach");
    sliced.summary.notes.emplace_back(waiting);
  }
  note(summary.reordered_layers, "are deposited in another order, so that places are left alone for longer");
  note(summary.too_fast_layers, "take less than their least time, even at the least feed");
}

}  // namespace

CoolingSettings reachableParking(const SlicedPart& sliced, CoolingSettings cooling, const BuildSpace& space) {
  if (cooling.park != ParkPlace::Stay && !canPark(sliced, cooling, space)) cooling.park = ParkPlace::Stay;
  return cooling;
}

void coolPart(SlicedPart& sliced, const SliceJob& job, const BuildSpace& space, Progress& progress) {
  CoolingSettings cooling = job.settings.cooling;
  FanSettings fan = job.settings.fan;
  const CarriedCooling carried = carriedBy(job);
  if (depositsDrops(job.settings.planning.infill.strategy)) {
    if (cooling.least_layer_time_s > 0.0 || fan.is_used)
      sliced.summary.notes.push_back("cooling.* and fan.* have no effect with infill.strategy '" +
                                     job.settings.planning.infill.strategy + "'");
    cooling.least_layer_time_s = 0.0;
    fan.is_used = false;
  }
  if (!carried.waits && cooling.by == CoolingBy::SlowThenDwell) cooling.by = CoolingBy::Slow;
  giveTimes(sliced, cooling, {space, job.settings.motion}, progress);
  if (fan.is_used && !carried.fan) {
    sliced.summary.notes.push_back("fan.use has no effect: " + carried.by + " carries no fan");
    fan.is_used = false;
  }
  addFan(sliced.toolpath, fan, job.settings.motion);
}

}  // namespace lamina
