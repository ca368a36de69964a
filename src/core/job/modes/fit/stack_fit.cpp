// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/stack_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/joint_program.hpp"
#include "job/modes/fit/hopeless_layers.hpp"
#include "job/modes/fit/plan_check.hpp"
#include "job/modes/settled_axis.hpp"
#include "job/modes/travels_over_part.hpp"
#include "job/raised_axes.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {
namespace {

constexpr double kSettledRad = toRadians(1.0);

std::size_t hindered(const MachineCheck& check) { return check.faults.size() + check.collisions.size(); }

bool isOf(JointFault fault, const Finding& finding) { return finding.what == toString(fault); }

/// Whether the tool axis leans at a waypoint.
bool isLeaning(const Toolpath& toolpath, const WaypointIndex& at, const Eigen::Isometry3d& bed_from_part) {
  const Path& path = toolpath.layers[at.layer].paths[at.path];
  const Point3 jet = bed_from_part.linear() * (path.orientation.at(at.waypoint) * Point3::UnitZ());
  return jet.z() > -std::cos(kSettledRad);
}

/// Faults but joints that turn too far beside a singularity, or are beyond their limits where the tool axis
/// leans: less lean, as near the bed, may bring these back. More room changes nothing where a place is out of
/// reach.
std::vector<Finding> unmendableFaults(const MachineCheck& check, const Toolpath& toolpath,
                                      const Eigen::Isometry3d& bed_from_part) {
  std::vector<Finding> unmendable;
  std::copy_if(
      check.faults.begin(), check.faults.end(), std::back_inserter(unmendable), [&](const Finding& fault) {
        return !isOf(JointFault::Singular, fault) &&
               !(isOf(JointFault::OutOfLimits, fault) && isLeaning(toolpath, fault.at, bed_from_part));
      });
  return unmendable;
}

bool isBeyondLimits(const MachineCheck& check) {
  return std::any_of(check.faults.begin(), check.faults.end(),
                     [](const Finding& fault) { return isOf(JointFault::OutOfLimits, fault); });
}

bool turnsTooFar(const MachineCheck& check) {
  return std::any_of(check.faults.begin(), check.faults.end(),
                     [](const Finding& fault) { return isOf(JointFault::Singular, fault); });
}

std::string textOf(const HopelessLayers& hopeless, std::size_t layers) {
  char text[320];
  if (hopeless.is_out_of_reach)
    std::snprintf(text, sizeof text,
                  ", in %zu of %zu layers, the only ones that were looked at: no leaning less and no leaving "
                  "out of beads mends that",
                  hopeless.layers, layers);
  else
    std::snprintf(text, sizeof text,
                  ", in %zu of %zu layers, the only ones that were looked at: %.4g mm³ of beads lead there, "
                  "however far "
                  "tool axes are raised; expected at most %.4g mm³ in the whole part "
                  "(volumetric.largest_left_out_percent)",
                  hopeless.layers, layers, hopeless.hindered_mm3, hopeless.most_mm3);
  return text;
}

[[noreturn]] void refuse(const HopelessLayers& hopeless, std::size_t layers, const KinematicModel& model) {
  const std::string text = textOf(hopeless, layers);
  try {
    requireClear(hopeless.check, model);
  } catch (const Unreachable& refusal) {
    throw Unreachable(refusal.what() + text);
  }
  throw Unreachable(text);
}

TravelsOverPart asPlanned(Toolpath& /*toolpath*/) { return {}; }

/// A stack that is changed step by step until the machine can run it.
class StackFitting {
 public:
  StackFitting(const PlanningRequest& request, double standing_mm, Progress& progress)
      : request_(request),
        standing_mm_(standing_mm),
        progress_(progress),
        check_(request, as_planned_, progress, PlanLimits::AsRun) {}

  StackFit fit(Toolpath planned) {
    refuseHopeless(planned);
    found_ = checked(planned);
    if (found_.isClear() || !unmendableFaults(found_, planned, request_.bed_from_part).empty())
      return {std::move(planned), {}};
    fitted_.toolpath = planned;
    if (turnsTooFar(found_)) settle();
    if (!found_.collisions.empty() || isBeyondLimits(found_)) raise();
    if (!found_.isClear() && mayBeLeftOut()) cut();
    if (found_.isClear()) return std::move(fitted_);
    return {std::move(planned), {}};
  }

 private:
  /// External axes that are led stand elsewhere in a few layers than in the whole, which may be in reach
  /// then. With `clearance.raise_tool_axis` the program is raised at all that is found, also where a head
  /// that leans takes the wrist out of reach.
  void refuseHopeless(const Toolpath& planned) const {
    const JobSettings& settings = request_.job.settings;
    if (settings.joints.external != ExternalChoice::Held || settings.joints.rail != RailChoice::Held) return;
    const auto unmendable = [&](const MachineCheck& check) {
      return settings.clearance.raises_tool_axis ? std::vector<Finding>()
                                                 : unmendableFaults(check, planned, request_.bed_from_part);
    };
    const RaisingSite site{check_.model(), request_.bed_from_part, settings};
    if (const std::optional<HopelessLayers> hopeless = hopelessLayers(planned, site, check_, unmendable))
      refuse(*hopeless, planned.layers.size(), check_.model());
  }

  MachineCheck checked(const Toolpath& toolpath) const { return check_.whole(toolpath).check; }

  /// Not where more joints turn too far then: a motion that ends upright may be the one that turns them.
  void settle() {
    Toolpath settled = fitted_.toolpath;
    settleAxes(settled, kSettledRad);
    MachineCheck check = checked(settled);
    if (hindered(check) >= hindered(found_)) return;
    fitted_.notes.emplace_back(
        "tool axes that are nearly upright are turned by up to 1 deg: a joint would turn too far there");
    fitted_.toolpath = std::move(settled);
    found_ = std::move(check);
  }

  void raise() {
    RaisedToolpath raised = raiseToolAxes(
        fitted_.toolpath, {check_.model(), request_.bed_from_part, request_.job.settings},
        [&](const Toolpath& toolpath) { return checked(toolpath); }, RaiseGoal::Fewest);
    if (raised.waypoints == 0 || hindered(raised.check) >= hindered(found_)) return;
    fitted_.notes.push_back(noteOnRaised(raised));
    fitted_.toolpath = std::move(raised.toolpath);
    found_ = std::move(raised.check);
  }

  bool mayBeLeftOut() const {
    const double most_mm3 = 0.01 * request_.job.settings.volumetric.largest_left_out_percent *
                            totals(fitted_.toolpath).deposited_mm3;
    return hinderedVolume(found_, fitted_.toolpath) <= most_mm3;
  }

  void cut() {
    const double deposited_mm3 = totals(fitted_.toolpath).deposited_mm3;
    MachineFit cut =
        fitToMachine(std::move(fitted_.toolpath), request_, as_planned_, progress_, standing_mm_);
    fitted_.toolpath = std::move(cut.toolpath);
    found_ = checked(fitted_.toolpath);
    fitted_.notes.push_back(noteOnFit(cut, deposited_mm3));
  }

  const PlanningRequest& request_;
  double standing_mm_;
  Progress& progress_;
  LeadTravels as_planned_ = asPlanned;
  PlanCheck check_;
  MachineCheck found_;
  StackFit fitted_;
};

}  // namespace

MachineFit fitGrown(Toolpath planned, const GrownRoom& grown, const PlanningRequest& request,
                    Progress& progress) {
  settleAxes(planned, kSettledRad);
  const JobSettings& settings = request.job.settings;
  const LeadTravels lead = [&](Toolpath& toolpath) {
    return leadTravels(toolpath, grown.growth_mm, grown.room, settings.planning.travel.hop_mm, progress);
  };
  if (canTurnToolAxis(request.space) && settings.clearance.need != ClearanceNeed::Never)
    return fitToMachine(std::move(planned), request, lead, progress);
  MachineFit fit;
  fit.travels = lead(planned);
  fit.toolpath = std::move(planned);
  return fit;
}

StackFit fitStack(Toolpath planned, double standing_mm, const PlanningRequest& request, Progress& progress) {
  if (!canTurnToolAxis(request.space) || !isRefusedUnlessClear(request.job)) return {std::move(planned), {}};
  return StackFitting(request, standing_mm, progress).fit(std::move(planned));
}

std::string noteOnFit(const MachineFit& fit, double deposited_mm3) {
  char text[300];
  std::snprintf(
      text, sizeof text,
      "at %zu waypoints the head had no room, or a joint turned too far, with %zu left: %.3g mm³ of beads, "
      "%.2f %%, are left out there, and the nozzle turns off the bead at %zu places",
      fit.hindered, fit.still_hindered, fit.left_out_mm3,
      deposited_mm3 > 0.0 ? 100.0 * fit.left_out_mm3 / deposited_mm3 : 0.0, fit.turns);
  return text;
}

}  // namespace lamina
