// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/machine_fit.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/job/machine_check.hpp"
#include "planning/runs/cut_beads.hpp"
#include "planning/travel/space_travel.hpp"

namespace lamina {
namespace {

constexpr int kMostCuts = 8;
constexpr double kHighMm = 5.0;  // of a travel over its bead

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

/// A plan that is mended bit by bit.
class Mending {
 public:
  Mending(Toolpath beads, const JobSettings& settings, double standing_mm)
      : beads_(std::move(beads)),
        travel_(settings.planning.travel),
        off_mm_(std::max(travel_.hop_mm, settings.planning.bead.width_mm)),
        standing_mm_(standing_mm),
        most_mm3_(0.01 * settings.volumetric.largest_left_out_percent * totals(beads_).deposited_mm3) {}

  /// Its travels not led yet.
  const Toolpath& beads() const { return beads_; }

  /// Mends what hinders the machine; not more often than `kMostCuts`, and not if too much would be left out.
  /// @param checked  these beads
  /// @return whether anything was mended
  bool mend(const CheckedPlan& checked) {
    const HinderedWaypoints hindered = hinderedBy(checked.check, beads_, checked.toolpath);
    if (hindered.isEmpty() || cuts_ == kMostCuts) return false;
    const TravelMaker travels = spaceTravels(beads_.layers, travel_, standing_mm_);
    CutBeads cut = cutBeads(beads_, hindered, travels, off_mm_);
    if (left_out_mm3_ + cut.left_out_mm3 > most_mm3_) return false;
    beads_ = std::move(cut.toolpath);
    left_out_mm3_ += cut.left_out_mm3;
    turns_ += cut.turns;
    ++cuts_;
    return true;
  }

  /// @param checked   these beads
  /// @param hindered  waypoints of what was planned
  MachineFit fit(const CheckedPlan& checked, std::size_t hindered) const {
    return {checked.toolpath, checked.travels, left_out_mm3_, turns_, hindered, checked.hindered()};
  }

 private:
  Toolpath beads_;
  TravelSettings travel_;
  double off_mm_;  ///< by which the nozzle leaves a bead, at least
  double standing_mm_;
  double most_mm3_;  ///< that may be left out
  double left_out_mm3_ = 0.0;
  std::size_t turns_ = 0;
  int cuts_ = 0;
};

}  // namespace

MachineFit fitToMachine(Toolpath beads, const PlanningRequest& request, const LeadTravels& lead,
                        Progress& progress, double standing_mm) {
  const PlanCheck check(request, lead, progress);
  Mending mending(std::move(beads), request.job.settings, standing_mm);
  CheckedPlan checked = check.whole(mending.beads());
  const std::size_t hindered = checked.hindered();
  MachineFit best = mending.fit(checked, hindered);
  while (mending.mend(checked)) {
    do {
      checked = check.again(mending.beads(), checked);
    } while (mending.mend(checked));
    checked = check.whole(mending.beads());
    if (checked.hindered() < best.still_hindered) best = mending.fit(checked, hindered);
  }
  return best;
}

}  // namespace lamina
