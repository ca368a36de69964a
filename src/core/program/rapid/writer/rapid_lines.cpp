// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_lines.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/decimals.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "program/external_axes.hpp"
#include "program/rapid/rapid_words.hpp"

namespace lamina {
namespace {

constexpr int kPositionDecimals = 4;
constexpr int kOrientationDecimals = 7;
constexpr int kAxisDecimals = 3;
constexpr int kWaitDecimals = 3;      // s
constexpr int kDistanceDecimals = 3;  // mm
constexpr int kLevelDecimals = 6;

std::string unlessDry() { return "IF NOT " + std::string(kRapidDryFlag) + " "; }

std::string startOfProcess(const RapidSettings& settings) {
  if (settings.variant != RapidVariant::Wire3Axes) return settings.laser_on + ";";
  const std::string start = "WaitDI " + settings.laser_ready_signal + ",high;Set " + settings.wire_signal +
                            ";WaitTime waiting1;Set " + settings.laser_signal + ";WaitTime waiting2;";
  // A laser that is not asked for may never be ready.
  return settings.has_dry_flag ? unlessDry() + "THEN " + start + "ENDIF " : start;
}

std::string endOfProcess(const RapidSettings& settings) {
  if (settings.variant == RapidVariant::Wire3Axes)
    return "Reset " + settings.laser_signal + ";WaitTime t_capas;";
  std::string text = settings.laser_off + ";WaitTime ";
  appendShortest(text, settings.laser_off_wait_s);
  return text + ";";
}

}  // namespace

std::string rapidConfiguration(const RapidSettings& settings) {
  std::string text = "[";
  for (std::size_t i = 0; i < settings.fixed_configuration.size(); ++i) {
    if (i > 0) text += ',';
    appendDecimals(text, settings.fixed_configuration[i], 0);
  }
  return text + "]";
}

std::string rapidExternalAxes(std::vector<double> values, const RapidSettings& settings) {
  if (values.empty() && settings.has_external_axis) values.push_back(settings.external_axis);
  const std::size_t count = settings.is_thesis_compatible ? kThesisAxes : 6;
  std::vector<std::optional<double>> axes(values.begin(), values.end());
  if (!settings.external_map.empty() && !values.empty()) {
    if (values.size() != settings.external_map.size())
      throw InvalidInput("a target has " + std::to_string(values.size()) + " external axes; expected " +
                         std::to_string(settings.external_map.size()) + ", as rapid.external_axes names");
    axes.assign(count, std::nullopt);
    for (std::size_t j = 0; j < values.size(); ++j) {
      const RapidExternal& external = settings.external_map[j];
      axes[external.slot] = external.sign * values[j] + external.zero;
    }
  }
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ',';
    if (i < axes.size() && axes[i])
      appendDecimals(text, *axes[i], kAxisDecimals);
    else
      text += "9e+09";
  }
  return text + "]";
}

std::string rapidConfiguration(const AbbConfiguration& configuration) {
  return "[" + std::to_string(configuration.cf1) + "," + std::to_string(configuration.cf4) + "," +
         std::to_string(configuration.cf6) + "," + std::to_string(configuration.cfx) + "]";
}

std::string rapidPose(const Point3& point, const Eigen::Quaterniond& turn) {
  const double numbers[] = {point.x(), point.y(), point.z(), turn.w(), turn.x(), turn.y(), turn.z()};
  std::string text = "[[";
  for (int i = 0; i < 7; ++i) {
    if (i > 0) text += i == 3 ? "],[" : ",";
    appendDecimals(text, numbers[i], i < 3 ? kPositionDecimals : kOrientationDecimals);
  }
  return text + "]";
}

std::string rapidOffset(const Point3& point, const RapidSettings& settings) {
  std::string text = "Offs(" + settings.start_point;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t sign = text.append(",").append(settings.offset).append(1, "xyz"[axis]).size();
    appendDecimals(text, point[static_cast<Eigen::Index>(axis)], kPositionDecimals);
    if (text[sign] != '-') text.insert(sign, 1, '+');
  }
  return text + ")";
}

RapidLines::RapidLines(const Toolpath& toolpath, const RapidPlan& plan, const RapidSpeeds& speeds,
                       const Eigen::Isometry3d& bed_from_part, const RapidSettings& settings)
    : toolpath_(toolpath),
      plan_(plan),
      speeds_(speeds),
      bed_from_part_(bed_from_part),
      turn_(bed_from_part.linear()),
      settings_(settings),
      levels_(rapidLevels(settings.levels)),
      fixed_axes_(rapidConfiguration(settings) + "," + rapidExternalAxes({}, settings)),
      on_(startOfProcess(settings)),
      off_(endOfProcess(settings)) {
  if (settings.variant != RapidVariant::Powder5Axes) {
    const Point3 start(settings.start_point_mm[0], settings.start_point_mm[1], settings.start_point_mm[2]);
    bed_from_part_.pretranslate(-start);
  }
  if (settings.variant == RapidVariant::Wire3Axes)
    wire_stops_ = rapidWireStops(plan.paths, settings.wire_stop_s);
  if (settings.process == RapidProcess::Arc)
    arc_ = settings.seam_data + "," + settings.weld_data +
           (settings.weave_data.empty() ? "" : "\\Weave:=" + settings.weave_data) + ",";
  tail_ = settings.tool + "\\WObj:=" + settings.work_object + ";\n";
}

void RapidLines::setRobot(const KinematicModel& arm, const ProgramStations& stations) {
  arm_ = &arm;
  stations_ = &stations;
}

bool RapidLines::isLastMove(const RapidPlace& place) const {
  return place.move + 1 == plan_.paths[place.path].moveCount();
}

bool RapidLines::startsAfter(const RapidPlace& place) const {
  const RapidPath& path = plan_.paths[place.path];
  if (path.is_turned && place.move == 0) return path.switches_on;
  if (!isLastMove(place) || place.path + 1 == plan_.paths.size()) return false;
  const RapidPath& next = plan_.paths[place.path + 1];
  return next.switches_on && !next.is_turned;
}

bool RapidLines::isFine(const RapidPlace& place) const {
  const RapidPath& path = plan_.paths[place.path];
  if (path.is_turned && place.move == 0) return true;
  if (dwellAfter(toolpath_, plan_.paths, place.path, place.move) > 0.0) return true;
  if (!isLastMove(place)) return false;
  const bool is_last = place.path + 1 == plan_.paths.size();
  return is_last || path.switches_off || startsAfter(place) || plan_.paths[place.path + 1].is_turned;
}

void RapidLines::append(const RapidPlace& place, std::string& text) const {
  const RapidPath& path = plan_.paths[place.path];
  const bool is_turn = path.is_turned && place.move == 0;
  const std::size_t waypoint = is_turn ? 0 : path.path->motionEnd(place.move - path.turnCount());
  const double feed = path.path->feed_mm_s.at(waypoint);
  const std::string& speed = is_turn           ? speeds_.approach()
                             : path.deposits() ? speeds_.deposition(feed)
                                               : speeds_.air(feed);
  text += instruction(place);
  appendTarget(place, waypoint, text);
  appendTail(place, speed, text);
  appendProcess(place, text);
  text += '\n';
}

bool RapidLines::isRunEnd(const RapidPlace& place) const {
  return isLastMove(place) && plan_.paths[place.path].switches_off;
}

bool RapidLines::isArc(const RapidPlace& place) const {
  const RapidPath& path = plan_.paths[place.path];
  const bool is_turn = path.is_turned && place.move == 0;
  return settings_.process == RapidProcess::Arc && (startsAfter(place) || (path.deposits() && !is_turn));
}

const char* RapidLines::instruction(const RapidPlace& place) const {
  if (isArc(place)) return startsAfter(place) ? "ArcLStart " : isRunEnd(place) ? "ArcLEnd " : "ArcL ";
  return triggersOn(place).empty() ? "MoveL " : "TriggL ";
}

/// Null if the wire does not stop on the way of the move.
const RapidWireStop* RapidLines::wireStopOn(const RapidPlace& place) const {
  const auto found = std::lower_bound(
      wire_stops_.begin(), wire_stops_.end(), place, [](const RapidWireStop& stop, const RapidPlace& wanted) {
        return std::pair(stop.move.path, stop.move.move) < std::pair(wanted.path, wanted.move);
      });
  const bool is_there =
      found != wire_stops_.end() && found->move.path == place.path && found->move.move == place.move;
  return is_there ? &*found : nullptr;
}

RapidPlace RapidLines::placeAfter(const RapidPlace& place) const {
  return isLastMove(place) ? RapidPlace{place.path + 1, 0} : RapidPlace{place.path, place.move + 1};
}

bool RapidLines::isBead(const RapidPlace& place) const {
  if (place.path >= plan_.paths.size()) return false;
  const RapidPath& path = plan_.paths[place.path];
  return path.deposits() && !(path.is_turned && place.move == 0);
}

/// What a bead's move asks for; nothing if its path does not state the value.
std::optional<double> RapidLines::levelOn(const RapidPlace& place, const RapidLevel& level) const {
  const RapidPath& path = plan_.paths[place.path];
  for (const ProcessValue& value : path.path->values)
    if (value.name == level.name)
      return level.per * value.value.at(path.path->motionEnd(place.move - path.turnCount()));
  return std::nullopt;
}

/// What the move before asks for, if it is one of the same run.
std::optional<double> RapidLines::levelBefore(const RapidPlace& place, const RapidLevel& level) const {
  const RapidPath& path = plan_.paths[place.path];
  if (place.move > path.turnCount()) return levelOn({place.path, place.move - 1}, level);
  if (path.switches_on || place.path == 0) return std::nullopt;
  return levelOn({place.path - 1, plan_.paths[place.path - 1].moveCount() - 1}, level);
}

/// The value that a level takes where a move sets out; nothing if it keeps its own.
std::optional<double> RapidLines::changedLevel(const RapidPlace& place, const RapidLevel& level) const {
  if (!isBead(place)) return std::nullopt;
  const std::optional<double> asked = levelOn(place, level);
  return asked == levelBefore(place, level) ? std::nullopt : asked;
}

/// Names of the triggers on the way of a move: of the wire, and of levels that change where it sets out
/// without coming to rest.
std::vector<std::string> RapidLines::triggersOn(const RapidPlace& place) const {
  std::vector<std::string> triggers;
  if (wireStopOn(place) != nullptr) triggers.push_back(settings_.wire_trigger);
  if (levels_.empty() || !isBead(place)) return triggers;
  const RapidPath& path = plan_.paths[place.path];
  RapidPlace before{place.path, place.move - 1};
  if (place.move == 0) before = {place.path - 1, plan_.paths[place.path - 1].moveCount() - 1};
  if (path.switches_on && place.move == path.turnCount()) return triggers;
  if (isFine(before)) return triggers;
  for (std::size_t k = 0; k < levels_.size(); ++k)
    if (changedLevel(place, levels_[k])) triggers.push_back(rapidLevelTrigger(k));
  return triggers;
}

/// Where the tip rests an output is set at once; otherwise by a trigger where the next move sets out, as the
/// program runs ahead of the robot.
void RapidLines::appendLevels(const RapidPlace& place, std::string& text) const {
  const RapidPlace next = placeAfter(place);
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const std::optional<double> value = changedLevel(next, levels_[k]);
    if (!value) continue;
    const std::string number = trimmedDecimals(*value, kLevelDecimals);
    text += isFine(place) ? levelAtRest(levels_[k], number) : levelOnTheWay(k, number);
  }
}

std::string RapidLines::levelAtRest(const RapidLevel& level, const std::string& number) const {
  const std::string statement = "SetAO " + level.signal + "," + number + ";";
  return isKeptDry(number) ? unlessDry() + statement : statement;
}

/// The move behind it names the trigger in a dry run too, which then leaves the output off.
std::string RapidLines::levelOnTheWay(std::size_t level, const std::string& number) const {
  const std::string trigger =
      "TriggIO " + rapidLevelTrigger(level) + ",0\\Start\\AOp:=" + levels_[level].signal + ",";
  const std::string statement = trigger + number + ";";
  return isKeptDry(number) ? unlessDry() + "THEN " + statement + "ELSE " + trigger + "0;ENDIF " : statement;
}

/// Whether a dry run leaves out what sets an output to that.
bool RapidLines::isKeptDry(const std::string& number) const {
  return settings_.has_dry_flag && number != "0";
}

/// What stands between two moves, but for arcs, whose moves switch the process.
void RapidLines::appendProcess(const RapidPlace& place, std::string& text) const {
  const bool by_outputs = settings_.process == RapidProcess::Outputs;
  if (by_outputs && isRunEnd(place)) {
    text += off_;
    for (const RapidLevel& level : levels_) text += "SetAO " + level.signal + ",0;";
  }
  const double dwell_s = dwellAfter(toolpath_, plan_.paths, place.path, place.move);
  if (dwell_s > 0.0) {
    text += "WaitTime\\InPos,";
    appendDecimals(text, dwell_s, kWaitDecimals);
    text += ';';
  }
  appendLevels(place, text);
  if (by_outputs && !isRunEnd(place) && startsAfter(place)) text += on_;
  const RapidPlace next = placeAfter(place);
  if (const RapidWireStop* stop = wireStopOn(next)) {
    text += "TriggIO " + settings_.wire_trigger + ",";
    appendDecimals(text, stop->distance_mm, kDistanceDecimals);
    text += "\\DOp:=" + settings_.wire_signal + ",0;";
  }
}

void RapidLines::appendTail(const RapidPlace& place, const std::string& speed, std::string& text) const {
  const std::string& zone = isFine(place) ? settings_.end_zone : settings_.zone;
  const char* comma = settings_.variant == RapidVariant::Powder5Axes ? "," : ", ";
  text.append(comma).append(speed).append(comma);
  const std::vector<std::string> triggers = triggersOn(place);
  for (std::size_t t = 0; t < triggers.size(); ++t)
    text.append(t == 0 ? "" : "\\T" + std::to_string(t + 1) + ":=").append(triggers[t]);
  if (!triggers.empty()) text += comma;
  if (isArc(place)) text.append(arc_);
  text.append(zone).append(settings_.variant == RapidVariant::Powder3Axes ? ", " : ",").append(tail_);
}

void RapidLines::appendTarget(const RapidPlace& place, std::size_t waypoint, std::string& text) const {
  const Path& path = *plan_.paths[place.path].path;
  const Point3 point = bed_from_part_ * path.points[waypoint];
  if (settings_.variant != RapidVariant::Powder5Axes) {
    text += rapidOffset(point, settings_);
    return;
  }
  text += rapidPose(point, turn_ * path.orientation.at(waypoint)) + ",";
  appendAxes(place, text);
  text += ']';
}

void RapidLines::appendAxes(const RapidPlace& place, std::string& text) const {
  if (stations_ == nullptr) {
    text += fixed_axes_;
    return;
  }
  const RapidPath& path = plan_.paths[place.path];
  const JointValues& joints = path.is_turned && place.move == 0
                                  ? stations_->begin(place.path)
                                  : stations_->end(place.path, place.move - path.turnCount());
  text += (settings_.configuration == RapidConfiguration::Fixed
               ? rapidConfiguration(settings_)
               : rapidConfiguration(abbConfiguration(*arm_, joints))) +
          "," + rapidExternalAxes(externalAxes(*arm_, joints), settings_);
}

}  // namespace lamina
