// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/machine_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"

namespace lamina {
namespace {

constexpr char kCollision[] = "collision";

std::string reasonOf(const Collision& collision, const DividedToolpath& divided) {
  const std::string link = "link '" + collision.link + "' is in ";
  if (collision.obstacle == Obstacle::Bed) return link + "the bed";
  if (collision.obstacle == Obstacle::Machine) return link + "link '" + collision.other + "'";
  return link + "what was deposited at " + toText(divided.originalOf(collision.deposited));
}

/// Whatever place of it a link is in.
std::string meetingOf(const Collision& collision) {
  const std::string link = "link '" + collision.link + "' in ";
  if (collision.obstacle == Obstacle::Bed) return link + "the bed";
  if (collision.obstacle == Obstacle::Machine) return link + "link '" + collision.other + "'";
  return link + "deposited material";
}

/// Findings in the order of the motion. Those of one kind at one waypoint are one: its motion may have many
/// steps, and a closed path comes to its start twice.
class Findings {
 public:
  void add(Finding finding) {
    if (known_.emplace(finding.at.layer, finding.at.path, finding.at.waypoint, finding.what).second)
      all_.push_back(std::move(finding));
  }
  std::vector<Finding> take() { return std::move(all_); }

 private:
  std::set<std::tuple<std::size_t, std::size_t, std::size_t, std::string>> known_;
  std::vector<Finding> all_;
};

std::size_t waypointsAskedFor(const DividedToolpath& divided) {
  std::size_t count = 0;
  for (const auto& layer : divided.original)
    for (const auto& path : layer)
      if (!path.empty()) count += *std::max_element(path.begin(), path.end()) + 1;
  return count;
}

/// The lines of waypoints that are asked for in the order of the motion.
class Lines {
 public:
  explicit Lines(const KinematicModelRun& run) : run_(run) {}
  std::size_t of(const WaypointIndex& at) {
    if (run_.lines.empty()) return 0;
    while (next_ + 1 < run_.path.at.size() && run_.path.at[next_] != at) ++next_;
    return run_.lines[next_];
  }

 private:
  const KinematicModelRun& run_;
  std::size_t next_ = 0;
};

std::vector<Finding> faultsOf(const KinematicModelRun& run) {
  Findings findings;
  Lines lines(run);
  for (const FaultyWaypoint& faulty : run.path.faults) {
    const Path& path = run.toolpath().layers[faulty.at.layer].paths[faulty.at.path];
    findings.add({run.divided.originalOf(faulty.at), path.points[faulty.at.waypoint], toString(faulty.fault),
                  faulty.reason, lines.of(faulty.at)});
  }
  return findings.take();
}

std::vector<Finding> collisionsOf(const KinematicModelRun& run, const JointClearanceReport& clearance) {
  Findings findings;
  const Eigen::Isometry3d part_from_bed = run.bed_from_part.inverse();
  Lines lines(run);
  for (const Collision& collision : clearance.collisions)
    findings.add({run.divided.originalOf(collision.at), part_from_bed * collision.tip, kCollision,
                  reasonOf(collision, run.divided), lines.of(collision.at), meetingOf(collision)});
  return findings.take();
}

/// Which way beside the part it is, for people.
std::string wayText(const RunPassage& passage, const KinematicModelRun& run) {
  if (passage.joints.before == 0) return "on the way to the part: ";
  return passage.joints.before < run.path.at.size() ? "on a way between two runs: "
                                                    : "on the way from the part: ";
}

/// Findings of ways beside the part, once for each line and kind.
class PassageFindings {
 public:
  PassageFindings(const KinematicModelRun& run, const KinematicModel& model) : run_(run), model_(model) {}

  std::vector<Finding> faults() const {
    std::vector<Finding> found;
    for (const RunPassage& passage : run_.passages)
      for (const PassageFault& fault : passage.faults)
        add({placeOf(passage), tipAt(passage, fault.index), toString(fault.fault),
             wayText(passage, run_) + fault.reason, passage.lines[fault.index]},
            found);
    return found;
  }

  std::vector<Finding> collisions(const std::vector<PassageCollision>& collisions) const {
    std::vector<Finding> found;
    for (const PassageCollision& each : collisions) {
      const RunPassage& passage = run_.passages[each.passage];
      add({placeOf(passage), run_.bed_from_part.inverse() * each.collision.tip, kCollision,
           wayText(passage, run_) + reasonOf(each.collision, run_.divided), passage.lines[each.index],
           meetingOf(each.collision)},
          found);
    }
    return found;
  }

 private:
  static void add(Finding finding, std::vector<Finding>& found) {
    const bool is_known =
        !found.empty() && found.back().line == finding.line && found.back().what == finding.what;
    if (!is_known) found.push_back(std::move(finding));
  }

  WaypointIndex placeOf(const RunPassage& passage) const {
    return run_.divided.originalOf(run_.path.at[std::min(passage.joints.before, run_.path.at.size() - 1)]);
  }

  Point3 tipAt(const RunPassage& passage, std::size_t index) const {
    const JointValues& values = passage.joints.values[index];
    if (values.size() == 0) return Point3::Zero();
    return run_.bed_from_part.inverse() * model_.bedFromNozzle(values).translation();
  }

  const KinematicModelRun& run_;
  const KinematicModel& model_;
};

constexpr std::size_t kMeetingsNamed = 3;

std::string counted(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " waypoint" : " waypoints");
}

/// A link and what it meets, over a whole run.
struct Meeting {
  std::string what;
  std::size_t waypoints = 0;
  std::size_t first_layer = 0;
};

/// The most frequent ones first.
std::vector<Meeting> meetingsOf(const std::vector<Finding>& collisions) {
  std::vector<Meeting> meetings;
  for (const Finding& finding : collisions) {
    if (finding.meeting.empty()) continue;
    const auto known = std::find_if(meetings.begin(), meetings.end(),
                                    [&](const Meeting& meeting) { return meeting.what == finding.meeting; });
    if (known == meetings.end())
      meetings.push_back({finding.meeting, 1, finding.at.layer});
    else
      ++known->waypoints;
  }
  std::stable_sort(meetings.begin(), meetings.end(),
                   [](const Meeting& a, const Meeting& b) { return a.waypoints > b.waypoints; });
  return meetings;
}

/// ": link 'head' in the bed at 7 waypoints from layer 3 on"; empty without collisions.
std::string meetingsText(const std::vector<Finding>& collisions) {
  const std::vector<Meeting> meetings = meetingsOf(collisions);
  std::string text;
  for (std::size_t i = 0; i < std::min(meetings.size(), kMeetingsNamed); ++i)
    text += (i == 0 ? ": " : ", ") + meetings[i].what + " at " + counted(meetings[i].waypoints) +
            " from layer " + std::to_string(meetings[i].first_layer) + " on";
  if (meetings.size() <= kMeetingsNamed) return text;
  const std::size_t more = meetings.size() - kMeetingsNamed;
  return text + ", and " + std::to_string(more) + (more == 1 ? " more pair" : " more pairs");
}

}  // namespace

MachineCheck checkRun(const KinematicModelRun& run, const CheckedMachine& machine,
                      const ClearanceSettings& settings, Progress& progress) {
  MachineCheck check;
  check.waypoints = waypointsAskedFor(run.divided);
  check.rewinds = run.path.rewinds;
  check.faults = faultsOf(run);
  check.ignored = machine.bodies().ignored;
  check.collisions =
      collisionsOf(run, checkJointClearance({run.toolpath(), run.bed_from_part, machine.model(), run.path},
                                            machine.bodies(), settings, progress));
  MachineCheck beside = checkPassages(run, machine, settings);
  std::move(beside.faults.begin(), beside.faults.end(), std::back_inserter(check.faults));
  std::move(beside.collisions.begin(), beside.collisions.end(), std::back_inserter(check.collisions));
  check.unknown_way = run.unknown_way;
  return check;
}

MachineCheck checkPassages(const KinematicModelRun& run, const CheckedMachine& machine,
                           const ClearanceSettings& settings) {
  MachineCheck check;
  const PassageFindings findings(run, machine.model());
  check.faults = findings.faults();
  std::vector<JointPassage> passages;
  passages.reserve(run.passages.size());
  for (const RunPassage& passage : run.passages) passages.push_back(passage.joints);
  check.collisions = findings.collisions(checkJointPassages(
      {run.toolpath(), run.bed_from_part, machine.model(), run.path}, passages, machine.bodies(), settings));
  return check;
}

MachineCheck checkRun(const KinematicModelRun& run, const KinematicModel& model,
                      const ClearanceSettings& settings, Progress& progress) {
  return checkRun(run, CheckedMachine(model), settings, progress);
}

ClearanceReport clearanceOf(const KinematicModelRun& run, const CheckedMachine& machine,
                            const ClearanceSettings& settings, Progress& progress) {
  const JointClearanceReport found = checkJointClearance(
      {run.toolpath(), run.bed_from_part, machine.model(), run.path}, machine.bodies(), settings, progress);
  ClearanceReport report;
  report.waypoints = waypointsAskedFor(run.divided);
  std::set<std::tuple<std::size_t, std::size_t, std::size_t>> colliding;
  std::set<std::size_t> layers;
  for (Collision collision : found.collisions) {
    collision.at = run.divided.originalOf(collision.at);
    if (collision.obstacle == Obstacle::Material)
      collision.deposited = run.divided.originalOf(collision.deposited);
    colliding.emplace(collision.at.layer, collision.at.path, collision.at.waypoint);
    if (layers.insert(collision.at.layer).second) report.first_of_layers.push_back(std::move(collision));
  }
  report.colliding = colliding.size();
  return report;
}

SingularBeads singularBeads(const KinematicModelRun& run, const KinematicModel& model, double margin_deg) {
  SingularBeads beads;
  for (std::size_t i = 0; i < run.path.at.size(); ++i) {
    const WaypointIndex& at = run.path.at[i];
    const bool is_bead = run.toolpath().layers[at.layer].paths[at.path].role != PathRole::Travel;
    if (!is_bead || run.path.values[i].size() == 0) continue;
    const double off_deg = toDegrees(std::asin(std::min(1.0, model.singularityMargin(run.path.values[i]))));
    ++beads.waypoints;
    beads.near += off_deg < margin_deg ? 1 : 0;
    if (off_deg >= beads.least_deg) continue;
    beads.least_deg = off_deg;
    beads.at = run.divided.originalOf(at);
    beads.line = run.lines.empty() ? 0 : run.lines[i];
  }
  return beads;
}

void requireClear(const MachineCheck& check, const KinematicModel& model) {
  if (check.isClear()) return;
  const Finding& first = check.faults.empty() ? check.collisions.front() : check.faults.front();
  std::vector<std::string> found;
  if (!check.faults.empty()) found.push_back("cannot run " + counted(check.faults.size()));
  if (!check.collisions.empty()) found.push_back("collides at " + counted(check.collisions.size()));
  throw Unreachable(toText(first.at) + ": " + first.reason + " (" + first.what + "; " + model.name() + " " +
                    listed(found, " and ") + ")" + meetingsText(check.collisions));
}

}  // namespace lamina
