// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/passages/run_passages.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kinematics/model/joint_ranges.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/kinematics/joint_path/stated_joints.hpp"
#include "lamina/kinematics/joint_path/straight_moves.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

constexpr double kSameStation = 1e-4;  // rad, mm: the digits of a program

/// A travel of one motion, over the bed.
Toolpath travelBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from.translation(), to.translation()};
  std::vector<Eigen::Quaterniond> turns = {Eigen::Quaterniond(from.linear()),
                                           Eigen::Quaterniond(to.linear())};
  if (turns[1].dot(turns[0]) < 0.0) turns[1].coeffs() *= -1.0;
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(turns));
  Toolpath toolpath;
  toolpath.layers.push_back({0.0, 0.0, {std::move(path)}});
  return toolpath;
}

/// Leads one passage, way by way.
class PassageLead {
 public:
  PassageLead(const KinematicModel& model, const JointPathSettings& settings)
      : model_(model), settings_(settings), ranges_(jointRanges(model.joints())) {}

  /// The place that the first way sets out from.
  void begin(const JointValues& values, std::size_t line) { push(values, line, 0.0); }

  void add(const StatedWay& way) {
    const bool is_known = !led_.joints.values.empty() && led_.joints.values.back().size() > 0;
    if (way.to.size() == 0) {
      push({}, way.line, 0.0);
      led_.faults.push_back({led_.lines.size() - 1, JointFault::OutOfReach, way.fault});
    } else if (!is_known || way.by == StatedMove::Joints) {
      push(way.to, way.line, 0.0);
    } else {
      leadStraight(way);
    }
  }

  RunPassage take(std::size_t before) {
    led_.joints.before = before;
    for (std::size_t i = 0; i < led_.lines.size(); ++i)
      if (led_.joints.values[i].size() > 0)
        if (const auto fault = statedLimitFault(led_.joints.values[i], model_))
          led_.faults.push_back({i, JointFault::OutOfLimits, *fault});
    return std::move(led_);
  }

 private:
  void push(JointValues values, std::size_t line, double feed_mm_s) {
    led_.joints.values.push_back(std::move(values));
    led_.lines.push_back(line);
    led_.feeds.push_back(feed_mm_s);
  }

  void leadStraight(const StatedWay& way) {
    const JointValues from = led_.joints.values.back();
    JointPath ends;
    ends.at = {{0, 0, 0}, {0, 0, 1}};
    ends.values = {from, way.to};
    DividedJointPath led =
        alongStraightMoves(travelBetween(model_.bedFromNozzle(from), model_.bedFromNozzle(way.to)),
                           std::move(ends), model_, settings_);
    const std::size_t first = led_.lines.size() - 1;  // at which `from` is
    for (std::size_t i = 1; i < led.joints.values.size(); ++i)
      push(std::move(led.joints.values[i]), way.line, way.feed_mm_s);
    for (FaultyWaypoint& each : led.joints.faults)
      led_.faults.push_back({first + each.at.waypoint, each.fault, std::move(each.reason)});
    for (std::size_t i = first + 1; i < led_.lines.size(); ++i) addJump(i);
  }

  void addJump(std::size_t i) {
    const JointValues& from = led_.joints.values[i - 1];
    const JointValues& to = led_.joints.values[i];
    if (from.size() == 0 || to.size() == 0) return;
    for (std::size_t j = 0; j < ranges_.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      if (!ranges_[j].is_rotary || std::abs(to[index] - from[index]) <= toRadians(settings_.max_turn_deg))
        continue;
      led_.faults.push_back({i, JointFault::Jump,
                             "joint " + model_.joints()[j].name + " turns from " +
                                 jointValueText(ranges_[j], from[index]) + " to " +
                                 jointValueText(ranges_[j], to[index]) + " at one place of a straight way"});
      return;
    }
  }

  const KinematicModel& model_;
  const JointPathSettings& settings_;
  std::vector<JointRange> ranges_;
  RunPassage led_;
};

bool isSameStation(const JointValues& one, const JointValues& other) {
  return one.size() == other.size() && one.size() > 0 && (one - other).cwiseAbs().maxCoeff() <= kSameStation;
}

/// From rest to rest.
double restToRest(double way, double speed, double acceleration) {
  const bool is_reached = way * acceleration >= speed * speed;
  return is_reached ? way / speed + speed / acceleration : 2.0 * std::sqrt(way / acceleration);
}

/// Times of the ways of one passage, each the values of one line.
class PassageClock {
 public:
  PassageClock(const KinematicModel& model, const TimingSettings& settings)
      : model_(model), settings_(settings) {}

  double time(const RunPassage& passage) const {
    const std::size_t count = passage.lines.size();
    double time_s = 0.0;
    for (std::size_t from = 0; from + 1 < count;) {
      std::size_t to = from + 1;
      while (to + 1 < count && passage.lines[to + 1] == passage.lines[to]) ++to;
      time_s += wayTime(passage, from, to);
      from = to;
    }
    return time_s;
  }

 private:
  double wayTime(const RunPassage& passage, std::size_t from, std::size_t to) const {
    const std::vector<JointValues>& values = passage.joints.values;
    for (std::size_t i = from; i <= to; ++i)
      if (values[i].size() == 0) return 0.0;
    const double feed = passage.feeds[to];
    if (feed == 0.0) return jointTime(values[from], values[to]);
    double way_mm = 0.0;
    double joints_s = 0.0;
    for (std::size_t i = from + 1; i <= to; ++i) {
      way_mm += (tip(values[i]) - tip(values[i - 1])).norm();
      joints_s += fastest(values[i - 1], values[i]);
    }
    return std::max(joints_s, restToRest(way_mm, feed, settings_.motion.travel_acceleration_mm_s2));
  }

  Point3 tip(const JointValues& values) const { return model_.bedFromNozzle(values).translation(); }

  double fastest(const JointValues& from, const JointValues& to) const {
    double time_s = 0.0;
    for (std::size_t j = 0; j < model_.joints().size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      time_s = std::max(time_s, std::abs(to[index] - from[index]) / model_.joints()[j].max_speed);
    }
    return time_s;
  }

  double jointTime(const JointValues& from, const JointValues& to) const {
    // In shares of the speeds, whose ramps are equally long.
    return restToRest(fastest(from, to), 1.0, 1.0 / settings_.trajectory.joint_ramp_s);
  }

  const KinematicModel& model_;
  const TimingSettings& settings_;
};

RunPassage ledPassage(const KinematicModel& model, const StatedMotion& motion, const StatedPassage& passage,
                      const JointPathSettings& settings) {
  PassageLead lead(model, settings);
  const std::vector<JointValues>& part = motion.joints.values;
  const std::size_t before = passage.before;
  if (before > 0) lead.begin(part[before - 1], motion.lines[before - 1]);
  for (const StatedWay& way : passage.ways) lead.add(way);
  // A passage that ends where it began leaves the move behind it as it is along the part.
  const bool is_back = before > 0 && isSameStation(passage.ways.back().to, part[before - 1]);
  if (before < part.size() && part[before].size() > 0 && !is_back) {
    StatedWay to_part;
    to_part.to = part[before];
    to_part.line = motion.lines[before];
    to_part.feed_mm_s = passage.feed_mm_s;
    lead.add(to_part);
  }
  return lead.take(before);
}

}  // namespace

std::vector<RunPassage> ledPassages(const KinematicModel& model, const StatedMotion& motion,
                                    const JointPathSettings& settings) {
  std::vector<RunPassage> led;
  led.reserve(motion.passages.size());
  for (const StatedPassage& passage : motion.passages)
    led.push_back(ledPassage(model, motion, passage, settings));
  return led;
}

double passageTime(const std::vector<RunPassage>& passages, const KinematicModel& model,
                   const TimingSettings& settings) {
  const PassageClock clock(model, settings);
  double time_s = 0.0;
  for (const RunPassage& passage : passages) time_s += clock.time(passage);
  return time_s;
}

std::string unknownWay(const StatedMotion& motion) {
  if (motion.between != StatedMove::Nozzle || motion.lines.empty()) return "";
  const bool is_led = !motion.passages.empty() && motion.passages.front().before == 0;
  const std::size_t line = is_led ? motion.passages.front().ways.front().line : motion.lines.front();
  return "the way to where line " + std::to_string(line) +
         " leads is not known, and not checked: the program begins wherever the arm stands";
}

}  // namespace lamina
