// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "chunk_correction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "correction_messages.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/layer_cells.hpp"
#include "lamina/control/program/correction_files.hpp"

namespace lamina {
namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr double kReplaced = 120.0;  // s: more than a controller has queued (feeder.ahead_s)

/// Rotary values by whole turns as near as can be to others.
JointValues turnedNear(JointValues values, const JointValues& near, const std::vector<DrivenJoint>& joints) {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (joints[j].kind == JointKind::Rotary) values[i] += kTurn * std::round((near[i] - values[i]) / kTurn);
  }
  return values;
}

/// Why a map of the toolpath cannot be applied to a trajectory, as the rest of a sentence; empty if it can.
std::string defectOfSpeeds(const CorrectionMap& map) {
  for (const PathCorrection& path : map.paths)
    for (const PointCorrection& place : path.stations)
      if (place.speed != 0.0)
        return "of layer " + std::to_string(map.layer) + " changes the speed by " + numberText(place.speed) +
               "; expected 0, as the motion is timed before it is handed over";
  return {};
}

void feed(ProcessSignals& process, double times) {
  process.flow_mm3_s *= times;
  for (const ProcessLevel level : kAllProcessLevels)
    if (followsSpeed(level)) process.levels[level] *= times;
}

/// The value at a time of what was handed over; 0 before the first.
double handedOver(const std::vector<std::pair<double, double>>& values, double time_s) {
  if (values.empty()) return 0.0;
  const auto after = std::lower_bound(values.begin(), values.end(), std::make_pair(time_s, -1e300));
  if (after == values.begin()) return values.front().second;
  if (after == values.end()) return values.back().second;
  const auto before = after - 1;
  const double part = (time_s - before->first) / (after->first - before->first);
  return before->second + part * (after->second - before->second);
}

/// Later values take the place of those from their time on. What is long past is asked for no more.
void handOver(std::vector<std::pair<double, double>>& values,
              const std::vector<std::pair<double, double>>& later) {
  const auto at = [&values](double time_s) {
    return std::lower_bound(values.begin(), values.end(), std::make_pair(time_s, -1e300));
  };
  const double from_s = later.front().first;
  values.erase(at(from_s), values.end());
  values.erase(values.begin(), at(from_s - kReplaced));
  values.insert(values.end(), later.begin(), later.end());
}

}  // namespace

ChunkCorrection::ChunkCorrection(DrivenToolpath toolpath, const LoopSettings& settings,
                                 const KinematicModel& model)
    : driven_(std::move(toolpath)),
      settings_(settings),
      model_(model),
      part_from_bed_(driven_.bed_from_part.inverse()) {}

std::string ChunkCorrection::hear(const CorrectionMap& map, const std::string& digest) {
  std::string defect = lamina::defectOf(map, driven_.id, driven_.toolpath);
  const bool is_of_layer = map.toolpath_id == driven_.id && map.layer < layers();
  if (defect.empty()) defect = defectOfSpeeds(map);
  if (isCoasting(map)) return keepCoasting(map, digest, defect);
  if (defect.empty() && handed_layer_ && map.layer < *handed_layer_)
    defect = "of layer " + std::to_string(map.layer) + " comes when layer " + std::to_string(*handed_layer_) +
             " is on its way";
  if (!defect.empty()) {
    defect = "the map " + defect;
    if (is_of_layer) miss(map.layer, defect);
    return defect;
  }
  maps_[map.layer] = ledMap(map, driven_.toolpath.layers[map.layer], feederOf(settings_), settings_);
  tellMapOf(map.layer, digest);
  return {};
}

/// One that comes when its layer has a map, or is on its way, is not needed.
std::string ChunkCorrection::keepCoasting(const CorrectionMap& map, const std::string& digest,
                                          const std::string& defect) {
  if (!defect.empty()) return "the coasting map " + defect;
  if (isKnown(map.layer) || (handed_layer_ && map.layer <= *handed_layer_)) return {};
  const ToolpathLayer& layer = driven_.toolpath.layers[map.layer];
  coasting_[map.layer] = {ledMap(map, layer, feederOf(settings_), settings_), digest};
  return {};
}

void ChunkCorrection::tellMapOf(std::size_t layer, const std::string& digest) {
  Reported& reported = reported_[layer];
  const bool is_trim = !reported.digest.empty() && !reported.is_coasting;
  reported.digest = digest;
  reported.is_coasting = false;
  if (is_trim) return;
  if (handed_layer_ == layer) {
    reported.held_from = handed_;
    late_ = layer;
  }
  layers_.push_back({driven_.id, digest, {layer, 0.0, {}, reported.held_from}});
}

void ChunkCorrection::miss(std::size_t layer, const std::string& reason, double waited_s) {
  if (layer >= layers()) return;
  const auto [entry, is_first] = reported_.try_emplace(layer);
  const Reported& reported = entry->second;
  if (!is_first && reported.digest.empty()) return;
  layers_.push_back({driven_.id, reported.digest, {layer, waited_s, reason, reported.held_from}});
}

void ChunkCorrection::giveUp(std::size_t layer, double waited_s) {
  const auto coasting = coasting_.find(layer);
  if (coasting != coasting_.end() && reported_.count(layer) == 0) {
    maps_[layer] = coasting->second.led;
    late_ = layer;
    reported_[layer] = {coasting->second.digest, {}, true};
    layers_.push_back({driven_.id, coasting->second.digest, {layer, waited_s, {}, {}}});
    return;
  }
  char reason[48];
  std::snprintf(reason, sizeof reason, "none came within %.3g s", waited_s);
  miss(layer, reason, waited_s);
}

void ChunkCorrection::refusePlan(const std::string& plan_id, const std::string& reason) {
  layers_.push_back({plan_id, {}, refusedPlan(reason)});
}

void ChunkCorrection::end() { missUnreported(layers()); }

void ChunkCorrection::missUnreported(std::size_t end) {
  for (std::size_t layer = handed_layer_.value_or(end); layer < end; ++layer)
    if (reported_.count(layer) == 0) miss(layer, "none came before the layer had been handed over");
}

/// A layer that lies behind without a map will have none.
void ChunkCorrection::noteHandedOver(const TrajectoryChunk& chunk) {
  for (auto point = chunk.points.rbegin(); point != chunk.points.rend(); ++point) {
    const WaypointIndex& at = point->heading_for;
    if (isTravel(at)) continue;
    missUnreported(at.layer);
    handed_layer_ = at.layer;
    handed_ = {at.path, alongAt(*point)};
    return;
  }
}

bool ChunkCorrection::isTravel(const WaypointIndex& heading_for) const {
  return driven_.toolpath.layers[heading_for.layer].paths[heading_for.path].role == PathRole::Travel;
}

const PathCorrection* ChunkCorrection::find(const WaypointIndex& heading_for) const {
  const auto map = maps_.find(heading_for.layer);
  if (map == maps_.end()) return nullptr;
  const std::vector<PathCorrection>& paths = map->second.paths;
  const auto found =
      std::lower_bound(paths.begin(), paths.end(), heading_for.path,
                       [](const PathCorrection& each, std::size_t path) { return each.path < path; });
  return found == paths.end() || found->path != heading_for.path ? nullptr : &*found;
}

/// From the start of the path to the tip [mm].
double ChunkCorrection::alongAt(const JointState& state) const {
  const Path& path = driven_.toolpath.layers[state.heading_for.layer].paths[state.heading_for.path];
  const Point3 tip = part_from_bed_ * model_.bedFromNozzle(state.position).translation();
  // Waypoint 0 of a closed path stands for its return.
  const bool is_return = path.is_closed && state.heading_for.waypoint == 0;
  const std::size_t motion =
      is_return ? path.points.size() - 1 : std::max<std::size_t>(1, state.heading_for.waypoint) - 1;
  if (motion >= path.motionCount()) return length(path);
  double along = 0.0;
  for (std::size_t m = 0; m < motion; ++m) along += (path.points[path.motionEnd(m)] - path.points[m]).norm();
  const Point3 way = path.points[path.motionEnd(motion)] - path.points[motion];
  const double way_mm = way.norm();
  if (!(way_mm > 0.0)) return along;
  return along + std::clamp((tip - path.points[motion]).dot(way) / way_mm, 0.0, way_mm);
}

/// None where no map is, as on travels: heights go back there.
ChunkCorrection::Asked ChunkCorrection::askedAt(const JointState& state) const {
  const PathCorrection* const correction = find(state.heading_for);
  if (correction == nullptr) return {};
  const PointCorrection here = correctionAt(*correction, alongAt(state));
  return {here.amount, here.dz_mm};
}

/// The amount that is taken. From path to path of a map it may step, as the feeder rests in between, and to
/// what has no cells, which is as planned.
double ChunkCorrection::followAmount(const JointState& state, double present, double wanted, double span_s) {
  const std::size_t layer = state.heading_for.layer;
  if (!hasCells(driven_.toolpath.layers[layer].paths[state.heading_for.path])) {
    if (late_ == layer) late_.reset();
    return 0.0;
  }
  if (isKnown(layer) && late_ != layer) return wanted;
  const double most = settings_.feeder_rate_s * span_s;
  const double taken = std::clamp(wanted, present - most, present + most);
  if (late_ == layer && taken == wanted) late_.reset();
  return taken;
}

/// The joints with the nozzle back along its axis; nothing if that is out of reach.
std::optional<JointValues> ChunkCorrection::movedBack(const JointValues& position, double height_mm) const {
  if (height_mm == 0.0) return position;
  Eigen::Isometry3d pose = model_.bedFromNozzle(position);
  const auto distance = [&](const InverseSolution& way) {
    return (turnedNear(way.values, position, model_.joints()) - position).cwiseAbs().maxCoeff();
  };
  const InverseSolutions ways = model_.solutions(pose, position);
  const auto present = std::min_element(
      ways.begin(), ways.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (present == ways.end()) return std::nullopt;
  pose.translation() -= height_mm * pose.linear().col(2);
  for (const InverseSolution& way : model_.solutions(pose, position))
    if (way.branch == present->branch) return turnedNear(way.values, position, model_.joints());
  return std::nullopt;
}

/// The joint that is out of its limits, in words; empty if none is.
std::string ChunkCorrection::defectOf(const JointValues& position) const {
  for (std::size_t j = 0; j < model_.joints().size(); ++j) {
    const DrivenJoint& joint = model_.joints()[j];
    const double value = position[static_cast<Eigen::Index>(j)];
    if (value >= joint.low && value <= joint.high) continue;
    const char* const unit = joint.kind == JointKind::Linear ? " mm" : " rad";
    return joint.name + " would be at " + numberText(value) + unit + "; its limits are " +
           numberText(joint.low) + " to " + numberText(joint.high) + unit;
  }
  return {};
}

/// The height that is taken: the one that is wanted, or else the present one.
double ChunkCorrection::follow(const JointState& state, double present_mm, double wanted_mm) {
  if (wanted_mm == 0.0) return wanted_mm;
  const std::optional<JointValues> position = movedBack(state.position, wanted_mm);
  const std::string defect = position ? defectOf(*position) : "the nozzle cannot reach it";
  if (defect.empty()) return wanted_mm;
  if (wanted_mm != present_mm && refusal_.empty())
    refusal_ = "layer " + std::to_string(state.heading_for.layer) + ", path " +
               std::to_string(state.heading_for.path) + ": the height stays at " + numberText(present_mm) +
               " mm, which was to become " + numberText(wanted_mm) + " mm: " + defect;
  return present_mm;
}

TrajectoryChunk ChunkCorrection::corrected(TrajectoryChunk chunk) {
  noteHandedOver(chunk);
  if (chunk.points.empty() || (maps_.empty() && heights_.empty())) return chunk;
  std::vector<std::pair<double, double>> heights;
  std::vector<JointValues> shifts;
  JointValues shift = JointValues::Zero(chunk.points.front().position.size());
  refusal_.clear();
  double height = handedOver(heights_, chunk.points.front().time_s);
  double amount = handedOver(amounts_, chunk.points.front().time_s);
  std::vector<std::pair<double, double>> amounts;
  double last_s = chunk.points.front().time_s;
  for (JointState& point : chunk.points) {
    const Asked asked = askedAt(point);
    const double most = kHeightSpeed * (point.time_s - last_s);
    height = follow(point, height, height + std::clamp(asked.dz_mm - height, -most, most));
    if (!isTravel(point.heading_for))
      amount = followAmount(point, amount, asked.amount, point.time_s - last_s);
    last_s = point.time_s;
    heights.emplace_back(point.time_s, height);
    amounts.emplace_back(point.time_s, amount);
    // Where even the present height is out of reach, the joints stay as far beside the plan as they are.
    const std::optional<JointValues> position = movedBack(point.position, height);
    if (position) shift = *position - point.position;
    shifts.push_back(shift);
    if (!isTravel(point.heading_for)) feed(point.process, 1.0 + amount);
  }
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    JointState& point = chunk.points[i];
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, shifts.size() - 1);
    const double span_s = chunk.points[after].time_s - chunk.points[before].time_s;
    point.position += shifts[i];
    if (span_s > 0.0) point.velocity += (shifts[after] - shifts[before]) / span_s;
  }
  handOver(heights_, heights);
  handOver(amounts_, amounts);
  return chunk;
}

}  // namespace lamina
