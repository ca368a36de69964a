// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop/loop_messages.hpp"

#include <type_traits>
#include <vector>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "point_cloud.hpp"

namespace lamina {
namespace {

using StateMessage = lamina_msgs::LoopState;

template <class Enum>
constexpr std::uint8_t numberOf(Enum value) {
  return static_cast<std::uint8_t>(value);
}

static_assert(numberOf(LoopState::Off) == StateMessage::OFF);
static_assert(numberOf(LoopState::Identifying) == StateMessage::IDENTIFYING);
static_assert(numberOf(LoopState::Active) == StateMessage::ACTIVE);
static_assert(numberOf(LoopState::Coasting) == StateMessage::COASTING);
static_assert(numberOf(LoopState::Open) == StateMessage::OPEN);
static_assert(numberOf(LoopState::Blocked) == StateMessage::BLOCKED);
static_assert(numberOf(CoastingFor::Nothing) == StateMessage::NOTHING);
static_assert(numberOf(CoastingFor::Sight) == StateMessage::SIGHT);
static_assert(numberOf(CoastingFor::TimeOffset) == StateMessage::TIME_OFFSET);
static_assert(numberOf(CoastingFor::Suspect) == StateMessage::SUSPECT);
static_assert(numberOf(LoopReaction::Warn) == StateMessage::WARN);
static_assert(numberOf(LoopReaction::LeaveOut) == StateMessage::LEAVE_OUT);
static_assert(numberOf(LoopReaction::Coast) == StateMessage::COAST);
static_assert(numberOf(LoopReaction::Open) == StateMessage::OPEN_LOOP);
static_assert(numberOf(LoopReaction::Replan) == StateMessage::REPLAN);
static_assert(numberOf(LoopReaction::Hold) == StateMessage::HOLD);

}  // namespace

lamina_msgs::LoopState toMessage(const LoopRun* run) {
  lamina_msgs::LoopState message;
  message.state_name = toString(LoopState::Off);
  if (run == nullptr) return message;
  const LoopStatus& status = run->status();
  message.toolpath_id = run->part().toolpath_id;
  message.layer = static_cast<std::uint32_t>(run->place().layer);
  message.state = numberOf(status.state);
  message.state_name = toString(status.state);
  message.coasting_for = numberOf(status.coasting_for);
  message.reason = status.reason;
  if (!run->lastAlarm()) return message;
  message.alarm = static_cast<std::uint16_t>(run->lastAlarm()->alarm);
  message.reaction = numberOf(run->lastAlarm()->reaction);
  if (message.reason.empty()) message.reason = run->lastAlarm()->reason;
  return message;
}

lamina_msgs::LoopFigures toMessage(const LayerOutcome& layer, const std::string& toolpath_id,
                                   const std::string& map_digest) {
  const LayerFigures& figures = layer.figures;
  lamina_msgs::LoopFigures message;
  message.toolpath_id = toolpath_id;
  message.layer = static_cast<std::uint32_t>(figures.layer);
  message.state = numberOf(layer.state);
  message.map_digest = map_digest;
  message.mean_error = toMetres(figures.mean_error_mm);
  message.rmse = toMetres(figures.rmse_mm);
  message.flatness = toMetres(figures.flatness_mm);
  message.coverage = figures.coverage;
  message.is_measured = figures.is_measured;
  message.contested_share = figures.contested_share;
  message.limited_share = figures.limited_share;
  message.deviating_share = figures.deviating_share;
  message.gain_mean = figures.gain_mean;
  message.gain_least = figures.gain_least;
  message.gain_greatest = figures.gain_greatest;
  message.consistency = figures.consistency;
  message.repeatability = figures.repeatability;
  for (const RaisedAlarm& alarm : layer.alarms)
    message.alarms.push_back(static_cast<std::uint16_t>(alarm.alarm));
  return message;
}

sensor_msgs::PointCloud2 toCloudMessage(const LayerOutcome& layer, const Eigen::Isometry3d& bed_from_part) {
  std::vector<Point3> points;
  CloudField error{"e", {}};
  CloudField amount{"m", {}};
  CloudField sigma{"sigma", {}};
  for (const CellOutcome& cell : layer.cells) {
    points.push_back(bed_from_part * cell.at);
    error.values.push_back(static_cast<float>(toMetres(cell.error_mm)));
    amount.values.push_back(static_cast<float>(cell.amount));
    sigma.values.push_back(static_cast<float>(toMetres(cell.sigma_mm)));
  }
  return toCloudMessage(points, {error, amount, sigma});
}

sensor_msgs::PointCloud2 gainCloudMessage(const LayerOutcome& layer, const Eigen::Isometry3d& bed_from_part) {
  std::vector<Point3> points;
  CloudField gain{"gain", {}};
  points.reserve(layer.cells.size());
  gain.values.reserve(layer.cells.size());
  for (const CellOutcome& cell : layer.cells) {
    points.push_back(bed_from_part * cell.at);
    gain.values.push_back(static_cast<float>(cell.gain));
  }
  return toCloudMessage(points, {gain});
}

LoopRequest loopRequestOf(const lamina_msgs::SetLoop::Request& request) {
  switch (request.request) {
    case lamina_msgs::SetLoop::Request::OFF:
      return LoopRequest::Off;
    case lamina_msgs::SetLoop::Request::IDENTIFY:
      return LoopRequest::Identify;
    case lamina_msgs::SetLoop::Request::ACTIVE:
      return LoopRequest::Active;
    default:
      throw InvalidInput("the request is " + std::to_string(request.request) +
                         "; expected OFF (0), IDENTIFY (1) or "
                         "ACTIVE (2)");
  }
}

}  // namespace lamina
