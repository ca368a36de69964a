// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "lamina/base/error.hpp"
#include "web/site_routes.hpp"

namespace lamina {
namespace {

using nlohmann::json;

constexpr double kStale = 3.0;  // [s]

json commandNames(const std::vector<UnitCommand>& commands) {
  json names = json::array();
  for (const UnitCommand command : commands) names.push_back(toString(command));
  return names;
}

json resumeStepsJson(const std::vector<ResumeStep>& steps) {
  constexpr std::array<const char*, 3> kStates = {"waits", "done", "person"};
  json list = json::array();
  for (const ResumeStep& step : steps)
    list.push_back({{"name", step.name},
                    {"state", kStates.at(static_cast<std::size_t>(step.state))},
                    {"text", step.text},
                    {"begin_mm", step.begin_mm ? json(*step.begin_mm) : json()}});
  return list;
}

json unitJson(const ShownUnit& unit) {
  json value = {{"state", toString(unit.state)},
                {"state_number", static_cast<int>(unit.state)},
                {"sequence", unit.sequence},
                {"in_state_s", std::floor(unit.in_state_s)},
                {"mode", unit.mode_name},
                {"mode_number", unit.mode},
                {"accepted_now", commandNames(unit.accepted_now)},
                {"resume_waits", unit.resume_waits},
                {"resume_refusal", unit.resume_refusal},
                {"resume_steps", resumeStepsJson(unit.resume_steps)},
                {"is_part_on_plate", unit.is_part_on_plate},
                {"takes_plc", unit.plc_access == PlcAccess::Allowed}};
  if (unit.stop_reason != 0)
    value["stop_reason"] = {{"alarm", unit.stop_reason}, {"message", unit.stop_message}};
  return value;
}

json progressJson(const ShownUnit& unit, const std::optional<LeftEstimate>& left) {
  json value = {{"lines", unit.lines},   {"lines_acknowledged", unit.lines_acknowledged},
                {"layer", unit.layer},   {"fraction", unit.fraction},
                {"laid_m", unit.laid_m}, {"material_m3", unit.material_m3}};
  if (left)
    value["left"] = {{"seconds", std::round(left->seconds)},
                     {"least_s", std::round(left->least_s)},
                     {"most_s", std::round(left->most_s)}};
  return value;
}

json machineJson(const CellSnapshot& seen, double steady_s) {
  if (!seen.machine_heard_s) return nullptr;
  const ShownMachine& machine = seen.machine;
  return {{"nozzle_degc", machine.nozzle_degc},
          {"bed_degc", machine.bed_degc},
          {"position_m", machine.position_m},
          {"age_s", std::floor(steady_s - *seen.machine_heard_s)},
          {"failure", machine.failure}};
}

json manualJson(const std::optional<ShownManual>& manual) {
  if (!manual) return nullptr;
  json joints = json::array();
  for (const ShownJoint& joint : manual->joints)
    joints.push_back({{"name", joint.name}, {"is_linear", joint.is_linear}});
  return {{"holder", manual->holder}, {"left_s", manual->left_s}, {"is_moving", manual->is_moving},
          {"scale", manual->scale},   {"reason", manual->reason}, {"joints", joints}};
}

}  // namespace

bool isFresh(const CellSnapshot& seen, const CellTime& now) {
  return seen.heard_s && now.steady_s - *seen.heard_s <= kStale;
}

json jobJson(const ShownJob& job) {
  return {{"id", job.id},
          {"name", job.name},
          {"part", job.part},
          {"machine", job.machine},
          {"digest", job.digest},
          {"state", toString(job.state)},
          {"created_by", job.created_by},
          {"released_by", job.released_by}};
}

json alarmsJson(const CellSnapshot& seen) {
  json alarms = json::array();
  for (const ShownAlarm& alarm : seen.alarms)
    alarms.push_back({{"id", alarm.id},
                      {"category", alarm.category},
                      {"title", alarm.title},
                      {"remedy", alarm.remedy},
                      {"message", alarm.message},
                      {"is_gone", alarm.is_gone},
                      {"is_acknowledged", alarm.is_acknowledged},
                      {"acknowledged_by", alarm.acknowledged_by},
                      {"times", alarm.times}});
  return alarms;
}

json startupJson(const CellSnapshot& seen) {
  json steps = json::array();
  for (const ShownStep& step : seen.startup)
    steps.push_back({{"name", step.name},
                     {"state", step.state},
                     {"reason", step.reason},
                     {"value", step.value},
                     {"unit", step.unit},
                     {"expected", step.expected}});
  return steps;
}

json layersJson(const CellSnapshot& seen) {
  json layers = json::array();
  for (const ShownLayer& layer : seen.layers)
    layers.push_back({{"layer", layer.layer},
                      {"mean_error_m", layer.mean_error_m},
                      {"rms_error_m", layer.rms_error_m},
                      {"worst_error_m", layer.worst_error_m},
                      {"coverage", layer.coverage}});
  return layers;
}

json stateJson(SiteParts& parts, WebRole role, const CellTime& now) {
  const CellSnapshot seen = parts.desk.snapshot();
  std::optional<LeftEstimate> left;
  {
    const std::lock_guard<std::mutex> lock(parts.history_mutex);
    left = parts.history.left();
  }
  const double age_s = seen.heard_s ? now.steady_s - *seen.heard_s : -1.0;
  json value = {{"utc_s", std::floor(now.utc_s)},
                {"is_fresh", isFresh(seen, now)},
                {"age_s", std::floor(age_s)},
                {"notices", parts.settings.notices}};
  if (!seen.heard_s) return value;
  value["unit"] = unitJson(seen.unit);
  value["progress"] = progressJson(seen.unit, left);
  value["job"] = seen.unit.job ? jobJson(*seen.unit.job) : json(nullptr);
  if (!mayDo(role, WebRight::SeeAll)) return value;
  value["machine"] = machineJson(seen, now.steady_s);
  value["alarms"] = alarmsJson(seen);
  value["queue"] = json::array();
  for (const ShownJob& job : seen.queue) value["queue"].push_back(jobJson(job));
  value["startup"] = startupJson(seen);
  value["loop"] = seen.loop ? json{{"state", seen.loop->state},
                                   {"reason", seen.loop->reason},
                                   {"layer", seen.loop->layer},
                                   {"alarm", seen.loop->alarm}}
                            : json(nullptr);
  value["manual"] = manualJson(seen.manual);
  value["layers"] = layersJson(seen);
  value["deviation_number"] = seen.deviation_number;
  value["has_camera"] = seen.has_camera;
  value["parts"] = seen.unit.parts;
  value["defective"] = seen.unit.defective;
  value["key_requests"] = json::array();
  for (const KeyRequest& request : parts.access.keyRequests(now))
    value["key_requests"].push_back(
        {{"id", request.id}, {"application", request.application}, {"from", request.from}});
  return value;
}

WebResponse jsonAnswer(int status, const json& value) {
  WebResponse response;
  response.status = status;
  // Names of files and words of machines may hold any bytes: those that are no UTF-8 are shown as such.
  response.body = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return response;
}

WebResponse errorAnswer(int status, const std::string& code, const std::string& message) {
  return jsonAnswer(status, {{"code", code}, {"message", message}});
}

WebResponse orderAnswer(const SiteCall& call, const DeskAnswer& answer) {
  switch (answer.outcome) {
    case DeskAnswer::Outcome::Done:
      return jsonAnswer(200, {{"message", answer.message}});
    case DeskAnswer::Outcome::BadInput:
      return errorAnswer(400, "bad_input", answer.message);
    case DeskAnswer::Outcome::Unknown:
      return errorAnswer(404, "unknown", answer.message);
    case DeskAnswer::Outcome::Silent:
      return errorAnswer(503, "no_answer", answer.message);
    case DeskAnswer::Outcome::Unsure:
      return errorAnswer(504, "no_answer", answer.message);
    case DeskAnswer::Outcome::Overtaken:
      return errorAnswer(409, "overtaken", answer.message);
    case DeskAnswer::Outcome::Refused:
      break;
  }
  const std::string code = answer.code == static_cast<int>(CommandResult::StaleSequence) ? "stale_sequence"
                           : answer.code == static_cast<int>(CommandResult::GuardFailed) ? "guard_failed"
                                                                                         : "refused";
  return jsonAnswer(409, {{"code", code},
                          {"message", answer.message},
                          {"accepted_now", commandNames(call.parts.desk.snapshot().unit.accepted_now)}});
}

json bodyObject(const SiteCall& call) {
  json value = json::parse(call.request.body.empty() ? "{}" : call.request.body, nullptr, false);
  if (!value.is_object()) throw InvalidInput("the body is no JSON object");
  return value;
}

std::int64_t wholeNumber(const std::string& text) {
  constexpr std::size_t kMostDigits = 15;
  const bool is_whole = !text.empty() && text.size() <= kMostDigits &&
                        text.find_first_not_of("0123456789") == std::string::npos;
  if (!is_whole)
    throw InvalidInput("'" + text.substr(0, 40) + "' is no whole number; expected one from 0 on");
  return std::stoll(text);
}

std::int64_t jobNumber(const std::string& text) {
  // Messages of ROS carry 32 bits: a larger number, cut to them, would be that of another job.
  constexpr std::int64_t kMostJob = 4294967295;
  const std::int64_t number = wholeNumber(text);
  if (number < 1 || number > kMostJob)
    throw InvalidInput("job " + text + "; expected 1 to " + std::to_string(kMostJob));
  return number;
}

std::string textOf(const json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return "";
  if (!found->is_string())
    throw InvalidInput("'" + key + "' is " +
                       found->dump(-1, ' ', true, json::error_handler_t::replace).substr(0, 40) +
                       "; expected a text");
  return found->get<std::string>();
}

}  // namespace lamina
