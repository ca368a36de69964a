// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/gravity_table.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <tuple>

#include "kinematics/arm/arm_model.hpp"
#include "kinematics/joint_path/taut_string.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kFreeTurn = std::numeric_limits<double>::infinity();
constexpr double kLeastTilt = 1e-3;  // sine: between the axes, and of the tilt's to the vertical
constexpr double kConeSlack = 1e-9;  // rad, of the cone
constexpr double kAlike = 1e-6;      // rad: greatest tilts of both ways

/// What is up over the bed, so that the nozzle points down.
Point3 upFor(const Station& station) { return -(station.orientation * Point3::UnitZ()); }

/// Of both ways to tilt: by how much they leave the limits [rad], their greatest tilt [rad], and how far the
/// tip is from axis 1 on average [mm].
struct TiltWay {
  int branch = 0;
  double outside = 0.0;
  double greatest = 0.0;
  double distance_mm = 0.0;
};

double distanceFromAxis(const GravityTable& table, const Point3& tip, const Eigen::Vector2d& angles) {
  JointValues external = JointValues::Zero(static_cast<Eigen::Index>(table.external.joints.size()));
  external[table.turn.in_chain] = angles[0];
  external[table.tilt.in_chain] = angles[1];
  const Point3 held = bedFromNozzle(table.external, external).inverse() * tip;
  return table.axis_1.direction.cross(held - table.axis_1.point).norm();
}

/// The numbers of whole turns that bring ranges of values into the limits of a joint, if only in part.
class WholeTurns {
 public:
  explicit WholeTurns(const JointRange& limits) : limits_(limits) {}

  /// @param highest  of the values at some place [rad]
  /// @param lowest   of them [rad]
  void keep(double highest, double lowest) {
    least_ = std::max(least_, (limits_.low - kLimitTolerance - highest) / (2.0 * M_PI));
    most_ = std::min(most_, (limits_.high + kLimitTolerance - lowest) / (2.0 * M_PI));
  }

  bool areAny() const { return std::ceil(least_) <= std::floor(most_); }

  /// Of the numbers, the one that leaves as much room on one side as on the other. There is one, and limits
  /// are finite.
  double central() const {
    return std::clamp(std::round(0.5 * (least_ + most_)), std::ceil(least_), std::floor(most_));
  }

 private:
  JointRange limits_;
  double least_ = -std::numeric_limits<double>::infinity();
  double most_ = std::numeric_limits<double>::infinity();
};

class TableLeading {
 public:
  TableLeading(const GravityTable& table, const std::vector<Station>& stations, const GravityRule& rule)
      : table_(table), stations_(stations), at_(passedAt(stations)), rule_(rule) {}

  /// Tilted the other way, the plate is half a turn on, which may be where its limits leave room.
  std::vector<TableValues> values() const {
    const int chosen = branch();
    std::vector<TableValues> values = valuesOf(chosen);
    if (isWithinTurns(values) || wayOf(1 - chosen).outside > kAlike) return values;
    std::vector<TableValues> others = valuesOf(1 - chosen);
    return isWithinTurns(others) ? others : values;
  }

 private:
  std::vector<TableValues> valuesOf(int branch) const {
    const std::vector<Eigen::Vector2d> exact = anglesOf(branch);
    const std::vector<double> tilts = tautString(tiltGates(exact));
    const std::vector<double> turns = turnsFor(tilts);
    std::vector<TableValues> values(stations_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {turns[i], tilts[i]};
    return values;
  }

  bool isWithinTurns(const std::vector<TableValues>& values) const {
    std::vector<double> turns;
    turns.reserve(values.size());
    for (const TableValues& each : values) turns.push_back(each.turn);
    return fitsLimits(turns, TurnBack::AnyTravel);
  }

  std::vector<Eigen::Vector2d> anglesOf(int branch) const {
    std::vector<Eigen::Vector2d> angles;
    angles.reserve(stations_.size());
    for (const Station& station : stations_) angles.push_back(exactAt(station)[branch].angles);
    return angles;
  }

  ToolAxisTurns exactAt(const Station& station) const {
    const Point3 up = upFor(station);
    ToolAxisTurns turns = toolAxisTurns(table_.up, up, {rule_.start, 0.0});
    if (turns.size() == 2) return turns;
    char text[200];
    std::snprintf(text, sizeof(text), "the table cannot turn the tool axis (%.4f, %.4f, %.4f) straight down",
                  -up.x(), -up.y(), -up.z());
    throw Unreachable("arm '" + table_.arm + "': " + text + "; expected one that its two axes reach");
  }

  TiltWay wayOf(int branch) const {
    TiltWay way{branch, 0.0, 0.0, 0.0};
    const JointRange& range = table_.tilt_range;
    for (const Station& station : stations_) {
      const Eigen::Vector2d angles = exactAt(station)[branch].angles;
      way.outside = std::max({way.outside, range.low - angles[1], angles[1] - range.high});
      way.greatest = std::max(way.greatest, std::abs(angles[1]));
      way.distance_mm += distanceFromAxis(table_, station.position, angles);
    }
    return way;
  }

  int branch() const {
    const TiltWay first = wayOf(0);
    const TiltWay second = wayOf(1);
    if (std::abs(first.outside - second.outside) > kAlike) return first.outside < second.outside ? 0 : 1;
    if (std::abs(first.greatest - second.greatest) > kAlike) return first.greatest < second.greatest ? 0 : 1;
    return second.distance_mm < first.distance_mm ? 1 : 0;
  }

  /// Where no value of the gate is within the limits it stays as it is: the joint's fault is reported later.
  std::vector<Gate> tiltGates(const std::vector<Eigen::Vector2d>& exact) const {
    const JointRange& range = table_.tilt_range;
    std::vector<Gate> gates;
    gates.reserve(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == exact.size();
      const double half = is_end ? 0.0 : 0.5 * rule_.cone;
      Gate gate{at_[i], exact[i][1] - half, exact[i][1] + half};
      if (gate.low <= range.high && gate.high >= range.low) {
        gate.low = std::max(gate.low, range.low);
        gate.high = std::min(gate.high, range.high);
      }
      gates.push_back(gate);
    }
    return gates;
  }

  /// The turn under which the tool axis is nearest to straight down, and how far to either side it stays
  /// within the cone.
  struct Room {
    double middle = 0.0;
    double half = kFreeTurn;
  };

  static bool isBound(const Room& room) { return std::isfinite(room.half); }

  Room roomAt(const Station& station, double tilt) const {
    const Point3& axis = table_.up.axes[0];
    const Point3 wanted = upFor(station);
    const Point3 tilted = Eigen::AngleAxisd(tilt, table_.up.axes[1]) * table_.up.at_zero;
    const double along = axis.dot(tilted) * axis.dot(wanted);
    const double across = axis.cross(tilted).norm() * axis.cross(wanted).norm();
    const double least = std::cos(std::max(0.0, rule_.cone - kConeSlack));
    if (along - across >= least) return {};
    return {angleAbout(axis, tilted, wanted), std::acos(std::clamp((least - along) / across, -1.0, 1.0))};
  }

  /// Middles go on from each other over whole turns; what is free has the middle before it.
  std::vector<Room> roomsFor(const std::vector<double>& tilts) const {
    std::vector<Room> rooms;
    rooms.reserve(tilts.size());
    double middle = rule_.start;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
      Room room = roomAt(stations_[i], tilts[i]);
      if (isBound(room)) middle += std::remainder(room.middle - middle, 2.0 * M_PI);
      rooms.push_back({middle, room.half});
    }
    return rooms;
  }

  std::vector<double> turnsFor(const std::vector<double>& tilts) const {
    const std::vector<Room> rooms = roomsFor(tilts);
    std::vector<double> on_and_on = turnsOnAndOn(rooms);
    if (fitsLimits(on_and_on, TurnBack::LiftedTravel)) return on_and_on;
    std::vector<double> turns = turnsByStretches(rooms, TurnBack::LiftedTravel);
    if (fitsLimits(turns, TurnBack::LiftedTravel)) return turns;
    if (fitsLimits(on_and_on, TurnBack::AnyTravel)) return on_and_on;
    return turnsByStretches(rooms, TurnBack::AnyTravel);
  }

  /// One string through all stations.
  std::vector<double> turnsOnAndOn(const std::vector<Room>& rooms) const {
    std::vector<Gate> gates;
    gates.reserve(rooms.size());
    std::size_t last_bound = 0;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      if (isBound(rooms[i])) last_bound = i;
      const double half = i == 0 ? 0.0 : rooms[i].half;
      gates.push_back({at_[i], rooms[i].middle - half, rooms[i].middle + half});
    }
    // What is free at the end needs no motion.
    gates.resize(last_bound + 1);
    const double end = 0.5 * (gates.back().low + gates.back().high);
    gates.back() = {at_[last_bound], end, end};
    std::vector<double> turns = tautString(gates);
    turns.resize(rooms.size(), turns.back());
    return turns;
  }

  /// On which travels the plate may be turned back. Without a lift the nozzle is a layer away from the part.
  enum class TurnBack { LiftedTravel, AnyTravel };

  static bool canTurnBack(const StationMotion& motion, TurnBack on) {
    return motion.way == StationWay::ClearTravel && (on == TurnBack::AnyTravel || motion.lift_mm > 0.0);
  }

  /// Where the plate can next be turned back after a station: on the clear motion of a travel.
  std::size_t stretchEnd(std::size_t begin, TurnBack on) const {
    std::size_t end = begin + 1;
    while (end < stations_.size() && !canTurnBack(stations_[end].motion, on)) ++end;
    return end;
  }

  std::vector<double> turnsByStretches(const std::vector<Room>& rooms, TurnBack on) const {
    std::vector<double> turns(rooms.size(), rule_.start);
    for (std::size_t begin = 0; begin < rooms.size();) {
      const std::size_t end = stretchEnd(begin, on);
      turnStretch(rooms, {begin, end}, turns);
      begin = end;
    }
    return turns;
  }

  /// Whether between any two such travels some number of whole turns brings all turns within the limits.
  bool fitsLimits(const std::vector<double>& turns, TurnBack on) const {
    for (std::size_t begin = 0; begin < turns.size();) {
      const std::size_t end = stretchEnd(begin, on);
      WholeTurns fitting(table_.turn_range);
      for (std::size_t i = begin; i < end; ++i) fitting.keep(turns[i], turns[i]);
      if (!fitting.areAny()) return false;
      begin = end;
    }
    return true;
  }

  struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  /// A string of its own for a stretch, within the limits if its rooms reach into them all. What is free
  /// before and after the string needs no motion.
  void turnStretch(const std::vector<Room>& rooms, Stretch stretch, std::vector<double>& turns) const {
    WholeTurns fitting(table_.turn_range);
    Stretch bound{stretch.end, stretch.begin};
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
      if (!isBound(rooms[i])) continue;
      bound = {std::min(bound.begin, i), i + 1};
      fitting.keep(rooms[i].middle + rooms[i].half, rooms[i].middle - rooms[i].half);
    }
    if (bound.begin == stretch.end) {
      const double held = stretch.begin == 0 ? rule_.start : turns[stretch.begin - 1];
      for (std::size_t i = stretch.begin; i < stretch.end; ++i) turns[i] = held;
      return;
    }
    const std::vector<double> string = tautString(stretchGates(rooms, bound, fitting));
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
      turns[i] = string[std::clamp(i, bound.begin, bound.end - 1) - bound.begin];
  }

  /// Straight down at both ends, or as nearly as the limits allow.
  std::vector<Gate> stretchGates(const std::vector<Room>& rooms, Stretch bound,
                                 const WholeTurns& fitting) const {
    const double turned = fitting.areAny() ? 2.0 * M_PI * fitting.central() : 0.0;
    std::vector<Gate> gates;
    gates.reserve(bound.end - bound.begin);
    for (std::size_t i = bound.begin; i < bound.end; ++i) {
      const bool is_end = i == bound.begin || i + 1 == bound.end;
      const double middle = rooms[i].middle + turned;
      const double half = is_end ? 0.0 : rooms[i].half;
      Gate gate{at_[i], middle - half, middle + half};
      if (fitting.areAny()) {
        gate.low = std::clamp(gate.low, table_.turn_range.low, table_.turn_range.high);
        gate.high = std::clamp(gate.high, table_.turn_range.low, table_.turn_range.high);
      }
      gates.push_back(gate);
    }
    return gates;
  }

  const GravityTable& table_;
  const std::vector<Station>& stations_;
  std::vector<double> at_;  ///< when each is passed [s]
  GravityRule rule_;
};

[[noreturn]] void refuseTable(const std::string& arm, const std::string& what) {
  throw InvalidConfig("arm '" + arm + "': " + what +
                      "; joints.external gravity expects a positioner that tilts and turns its plate");
}

}  // namespace

GravityTable gravityTable(const KinematicModel& model) {
  const ArmModel& arm = requireArm(model);
  GravityTable table;
  table.arm = arm.name();
  table.external = arm.chain().external;
  table.axis_1 = arm.chain().arm.screws[0];
  const std::vector<JointRange> ranges = jointRanges(table.external.joints);
  std::vector<std::size_t> rotary;
  for (std::size_t j = 0; j < ranges.size(); ++j)
    if (ranges[j].is_rotary) rotary.push_back(j);
  if (rotary.size() != 2)
    refuseTable(table.arm, "has " + std::to_string(rotary.size()) + " rotary external axes");
  for (const std::size_t j : rotary) table.up.axes.push_back(table.external.screws[j].direction);
  const JointValues zero = JointValues::Zero(static_cast<Eigen::Index>(model.joints().size()));
  table.up.at_zero = model.bedFromLinks(zero).at(arm.chain().whole.links.front().name).linear().col(2);
  if (sineBetween(table.up.axes[0], table.up.axes[1]) < kLeastTilt)
    refuseTable(table.arm, "both rotary external axes are parallel");
  if (sineBetween(table.up.axes[1], table.up.at_zero) < kLeastTilt)
    refuseTable(table.arm, "joint '" + table.external.joints[rotary[1]].name + "' turns about the vertical");
  const auto axisAt = [&](std::size_t j) {
    const Eigen::Index in_model = arm.chain().external_index[j];
    return TableAxis{static_cast<Eigen::Index>(j),
                     static_cast<std::size_t>(in_model) - arm.chain().arm_index.size()};
  };
  table.turn = axisAt(rotary[0]);
  table.tilt = axisAt(rotary[1]);
  table.turn_range = ranges[rotary[0]];
  table.tilt_range = ranges[rotary[1]];
  return table;
}

std::vector<TableValues> tableValues(const GravityTable& table, const std::vector<Station>& stations,
                                     const GravityRule& rule) {
  return TableLeading(table, stations, rule).values();
}

}  // namespace lamina
