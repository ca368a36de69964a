// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A wall of 150 mm radius that leans out from 0 to 60 deg, laid at 8 mm/s in a cell with a two-axis
// positioner: how far the nozzle is from straight down, how the plate turns, and the feed over the bed, all
// by forward kinematics, for rings that begin at each of 24 azimuths; the same with the table held. The
// argument is the cell file.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "support/tilting_arm.hpp"

namespace {

using namespace lamina;

constexpr double kRadius = 150.0;
constexpr double kFeed = 8.0;
constexpr int kSides = 120;
constexpr int kRings = 30;  // above the first, which does not lean

Path ringAt(int ring, double start) {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = kFeed;
  path.bead = Bead{3.0, 1.0};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= kSides; ++i) {
    const double azimuth = start + 2.0 * M_PI * i / kSides;
    path.points.emplace_back(kRadius * std::cos(azimuth), kRadius * std::sin(azimuth), 1.0 + ring);
    nozzles.push_back(test::nozzleOnWall(azimuth, ring * (60.0 * kDegree) / kRings));
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  return path;
}

/// Away from the part along the tool axis, up, and back.
Path travelTo(const Path& from, const Path& to) {
  const auto off = [](const Point3& point, const Eigen::Quaterniond& nozzle) {
    return Point3(point - 20.0 * (nozzle * Point3::UnitZ()));
  };
  const Eigen::Quaterniond first = from.orientation.at(0);
  const Eigen::Quaterniond last = to.orientation.at(0);
  Path travel;
  travel.role = PathRole::Travel;
  travel.feed_mm_s = 50.0;
  travel.points = {from.points.back(), off(from.points.back(), first), off(to.points.front(), last),
                   to.points.front()};
  travel.orientation = AlongPath<Eigen::Quaterniond>({first, first, last, last});
  return travel;
}

/// Rings above each other, from whose starts tables with limits wind back.
/// @param start  azimuth at which each begins
Toolpath leaningWall(double start) {
  Toolpath toolpath;
  toolpath.part_name = "wall";
  for (int ring = 0; ring <= kRings; ++ring) {
    ToolpathLayer layer{1.0 + ring, 1.0, {}};
    Path bead = ringAt(ring, start);
    if (ring > 0) layer.paths.push_back(travelTo(toolpath.layers.back().paths.back(), bead));
    layer.paths.push_back(std::move(bead));
    toolpath.layers.push_back(std::move(layer));
  }
  return toolpath;
}

/// From straight down in the room.
double offDown(const KinematicModel& model, const JointValues& values) {
  const Eigen::Isometry3d root_from_bed = model.bedFromLinks(values).at("cell_world").inverse();
  const Point3 axis = root_from_bed.linear() * model.bedFromNozzle(values).linear().col(2);
  return std::atan2(axis.head<2>().norm(), -axis.z());
}

/// Whether a motion of a joint path lays a bead, and not the travel before it.
bool isBead(const JointPath& joints, const Toolpath& toolpath, std::size_t i) {
  const WaypointIndex& at = joints.at[i];
  return joints.at[i - 1].layer == at.layer && joints.at[i - 1].path == at.path &&
         toolpath.layers[at.layer].paths[at.path].role != PathRole::Travel;
}

void printTurns(const KinematicModel& model, const DividedJointPath& planned) {
  const JointPath& joints = planned.joints;
  const Eigen::Index turn = joints.values.front().size() - 1;
  double off = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  double step = 0.0;
  for (std::size_t i = 1; i < joints.values.size(); ++i) {
    if (!isBead(joints, planned.divided.toolpath, i)) continue;
    off = std::max(off, offDown(model, joints.values[i]));
    const JointValues moved = joints.values[i] - joints.values[i - 1];
    lowest = std::min(lowest, moved[turn]);
    highest = std::max(highest, moved[turn]);
    step = std::max(step, moved.head<6>().cwiseAbs().maxCoeff());
  }
  std::printf(
      "nozzle off straight down %.3f deg at most; steps of the plate %.3f to %.3f deg; of the arm's joints "
      "%.3f deg at most; tip off its line %.4f mm at most; %zu waypoints, %zu rewinds\n",
      toDegrees(off), toDegrees(lowest), toDegrees(highest), toDegrees(step), planned.greatest.tip_mm,
      joints.values.size(), joints.rewinds);
}

/// Away from the ends of rings.
void printFeeds(const KinematicModel& model, const DividedJointPath& planned) {
  constexpr double kStep = 0.05;
  constexpr double kRamp = 2.0;
  const JointPath& joints = planned.joints;
  const TimedPath timed(planned.divided.toolpath, joints, model, TimingSettings());
  const std::vector<double>& times = timed.stationTimes();
  const Eigen::Index turn = joints.values.front().size() - 1;
  double least = kFeed;
  double most = kFeed;
  std::vector<double> turns;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= times.size(); ++i) {
    if (i < times.size() && isBead(joints, planned.divided.toolpath, i)) continue;
    for (double t = times[begin] + kRamp; t + kRamp + kStep < times[i - 1]; t += kStep) {
      const JointValues from = timed.at(t).position;
      const JointValues to = timed.at(t + kStep).position;
      const Point3 way = model.bedFromNozzle(to).translation() - model.bedFromNozzle(from).translation();
      least = std::min(least, way.norm() / kStep);
      most = std::max(most, way.norm() / kStep);
      turns.push_back(toDegrees(std::abs(to[turn] - from[turn])) / kStep);
    }
    begin = i;
  }
  std::sort(turns.begin(), turns.end());
  std::printf("feed over the bed %.4f to %.4f mm/s away from the ends of rings; plate %.4f deg/s, median\n",
              least, most, turns[turns.size() / 2]);
}

void runWall(const KinematicModel& model, ExternalChoice choice, int starts) {
  JointPathSettings settings;
  settings.external = choice;
  NoProgress nobody;
  int runnable = 0;
  for (int i = 0; i < starts; ++i) {
    const double start = -15.0 + 15.0 * i;
    const DividedJointPath planned = planDividedJointPath(
        leaningWall(start * kDegree), Eigen::Isometry3d::Identity(), model, settings, nobody);
    std::printf("rings from %.0f deg: ", start);
    if (planned.joints.isRunnable()) {
      ++runnable;
      printTurns(model, planned);
      printFeeds(model, planned);
      continue;
    }
    std::printf("refused at %zu of %zu waypoints: %s\n", planned.joints.faults.size(),
                planned.joints.at.size(), planned.joints.faults.front().reason.c_str());
  }
  std::printf("laid from %d of %d starts\n", runnable, starts);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: lamina_bench_positioner_wall CELL.yaml\n");
    return 2;
  }
  try {
    const auto model = kinematicModelFromUrdf(readMachineDescription(arguments[1]));
    std::printf("joints.external gravity\n");
    runWall(*model, ExternalChoice::Gravity, 24);
    std::printf("held\n");
    runWall(*model, ExternalChoice::Held, 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
