// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/machine_fit.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/kinematics/cartesian/machine_settings.hpp"
#include "planning/runs/cut_beads.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {
namespace {

constexpr int kMostCuts = 8;  // each ends in a check, which takes as long as `lamina check`
// Of what `lamina check` allows: a part that stands elsewhere, or a layer that is slowed down, is led
// otherwise.
constexpr double kOfSlowdown = 0.5;
constexpr double kOfTolerance = 0.8;
constexpr double kHighMm = 5.0;  // of a travel over its bead
constexpr double kNothingStands = -std::numeric_limits<double>::infinity();

/// Where the bead before a travel ends; nothing if there is none.
std::optional<WaypointIndex> endBefore(const WaypointIndex& travel, const Toolpath& toolpath) {
  for (std::size_t l = travel.layer + 1; l-- > 0;) {
    const std::vector<Path>& paths = toolpath.layers[l].paths;
    for (std::size_t p = l == travel.layer ? travel.path : paths.size(); p-- > 0;)
      if (paths[p].role != PathRole::Travel)
        return WaypointIndex{l, p, paths[p].is_closed ? 0 : paths[p].points.size() - 1};
  }
  return std::nullopt;
}

/// Where the bead after a travel starts; nothing if there is none.
std::optional<WaypointIndex> startAfter(const WaypointIndex& travel, const Toolpath& toolpath) {
  for (std::size_t l = travel.layer; l < toolpath.layers.size(); ++l) {
    const std::vector<Path>& paths = toolpath.layers[l].paths;
    for (std::size_t p = l == travel.layer ? travel.path + 1 : 0; p < paths.size(); ++p)
      if (paths[p].role != PathRole::Travel) return WaypointIndex{l, p, 0};
  }
  return std::nullopt;
}

/// The end of a travel that is nearer to one of its waypoints.
std::optional<WaypointIndex> endOf(const WaypointIndex& travel, const Toolpath& led) {
  const bool is_leaving = 2 * travel.waypoint <= led.layers[travel.layer].paths[travel.path].points.size();
  return is_leaving ? endBefore(travel, led) : startAfter(travel, led);
}

/// One that was led all over the part, or is high already, can only end elsewhere.
bool mayRise(const Path& planned, const Path& led) {
  return planned.points.size() == led.points.size() && rise(planned) < kHighMm;
}

/// @param planned  with its travels as they were before they were led
HinderedWaypoints hinderedBy(const MachineCheck& check, const Toolpath& planned, const Toolpath& led) {
  HinderedWaypoints hindered;
  for (const Finding& finding : check.collisions) {
    const WaypointIndex& at = finding.at;
    const Path& path = planned.layers[at.layer].paths[at.path];
    if (path.role != PathRole::Travel)
      hindered.shut.insert(at);
    else if (mayRise(path, led.layers[at.layer].paths[at.path]))
      hindered.low.insert({at.layer, at.path, 0});
    else if (const std::optional<WaypointIndex> end = endOf(at, led))
      hindered.shut.insert(*end);
  }
  for (const Finding& finding : check.faults) {
    const WaypointIndex& at = finding.at;
    if (finding.what == toString(JointFault::Singular) &&
        planned.layers[at.layer].paths[at.path].role != PathRole::Travel)
      hindered.turning.insert(at);
  }
  return hindered;
}

/// A toolpath whose travels are led, and what the machine cannot run of it.
struct Checked {
  Toolpath toolpath;
  TravelsOverPart travels;
  MachineCheck check;

  std::size_t hindered() const { return check.faults.size() + check.collisions.size(); }
};

Checked checkedOn(const KinematicModel& model, Toolpath toolpath, const PlanningRequest& request,
                  const LeadTravels& lead, Progress& progress) {
  JointPathSettings joints = request.job.settings.joints;
  joints.max_slowdown = std::max(1.0, kOfSlowdown * joints.max_slowdown);
  ClearanceSettings clearance = request.job.settings.clearance;
  clearance.tolerance_mm *= kOfTolerance;
  const TravelsOverPart travels = lead(toolpath);
  const KinematicModelRun run = runOn(model, toolpath, request.bed_from_part, joints, progress);
  return {std::move(toolpath), travels, checkRun(run, model, clearance, progress)};
}

}  // namespace

MachineFit fitToMachine(Toolpath beads, const PlanningRequest& request, const LeadTravels& lead,
                        Progress& progress) {
  const JobSettings& settings = request.job.settings;
  const std::unique_ptr<KinematicModel> model = kinematicModelOf(settings.machine);
  const double most_mm3 = 0.01 * settings.volumetric.largest_left_out_percent * totals(beads).deposited_mm3;
  const double off_mm = std::max(settings.planning.travel.hop_mm, settings.planning.bead.width_mm);
  Checked first = checkedOn(*model, beads, request, lead, progress);
  MachineFit fit;
  fit.hindered = fit.still_hindered = first.hindered();
  HinderedWaypoints hindered = hinderedBy(first.check, beads, first.toolpath);
  fit.toolpath = std::move(first.toolpath);
  fit.travels = first.travels;
  double left_out_mm3 = 0.0;
  std::size_t turns = 0;
  for (int cuts = 0; cuts < kMostCuts && !hindered.isEmpty(); ++cuts) {
    const TravelMaker travels = spaceTravels(beads.layers, settings.planning.travel, kNothingStands);
    CutBeads cut = cutBeads(std::move(beads), hindered, travels, off_mm);
    left_out_mm3 += cut.left_out_mm3;
    turns += cut.turns;
    if (left_out_mm3 > most_mm3) break;
    beads = std::move(cut.toolpath);
    Checked next = checkedOn(*model, beads, request, lead, progress);
    hindered = hinderedBy(next.check, beads, next.toolpath);
    if (next.hindered() < fit.still_hindered)
      fit = {std::move(next.toolpath), next.travels, left_out_mm3, turns, fit.hindered, next.hindered()};
  }
  return fit;
}

}  // namespace lamina
