// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/percent_encoding.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/base/text.hpp"
#include "lamina/base/version.hpp"
#include "web/site_routes.hpp"

// Enough of OctoPrint's interface that slicers find a printer and send to it. Source: OctoPrint's public API
// documentation; which requests clients make is in docs/cell/operator-page.md.
namespace lamina {
namespace {

using nlohmann::json;

struct Mapped {
  const char* text;
  bool is_printing = false;
  bool is_paused = false;
  bool is_ready = false;
  bool is_error = false;
};

Mapped mapped(UnitState state) {
  switch (state) {
    case UnitState::Execute:
    case UnitState::Starting:
    case UnitState::Completing:
    case UnitState::Unholding:
    case UnitState::Unsuspending:
      return {"Printing", true, false, false, false};
    case UnitState::Holding:
    case UnitState::Suspending:
      return {"Pausing", true, false, false, false};
    case UnitState::Held:
    case UnitState::Suspended:
      return {"Paused", false, true, false, false};
    case UnitState::Idle:
    case UnitState::Stopped:
    case UnitState::Complete:
    case UnitState::Resetting:
    case UnitState::Clearing:
      return {"Operational", false, false, true, false};
    case UnitState::Stopping:
    case UnitState::Aborting:
      return {"Cancelling", true, false, false, false};
    case UnitState::Aborted:
      return {"Error", false, false, false, true};
  }
  return {"Offline"};
}

Mapped stateOf(const CellSnapshot& seen, const CellTime& now) {
  if (!isFresh(seen, now)) return {"Offline", false, false, false, true};
  return mapped(seen.unit.state);
}

WebResponse getVersion(SiteCall& /*call*/) {
  return jsonAnswer(
      200, {{"api", "0.1"}, {"server", "1.5.0"}, {"text", "OctoPrint (Lamina " + laminaVersion() + ")"}});
}

WebResponse getServer(SiteCall& /*call*/) {
  return jsonAnswer(200, {{"version", "1.5.0"}, {"safemode", nullptr}});
}

json userJson(const SiteCall& call) {
  const bool is_operator = mayDo(*call.who().role, WebRight::Operate);
  return {{"name", call.who().name},
          {"active", true},
          {"admin", mayDo(*call.who().role, WebRight::Maintain)},
          {"user", true},
          {"apikey", nullptr},
          {"groups", is_operator ? json{"operator"} : json::array()},
          {"permissions", json::array()}};
}

WebResponse login(SiteCall& call) {
  json value = userJson(call);
  value["session"] = "";
  value["_is_external_client"] = !call.who().is_local;
  WebResponse response = jsonAnswer(200, value);
  response.note = "login by OctoPrint's interface";
  return response;
}

WebResponse getCurrentUser(SiteCall& call) { return jsonAnswer(200, userJson(call)); }

/// The page's identity in the form of a UUID of version 8, that of a maker's own kind.
std::string uuidOf(const std::string& identity) {
  std::string digits = sha256Of(identity).substr(0, 32);
  digits[12] = '8';
  digits[16] = 'a';
  for (const std::size_t at : {20U, 16U, 12U, 8U}) digits.insert(at, "-");
  return digits;
}

WebResponse getSettings(SiteCall& call) {
  // Home Assistant knows a printer by this, and adds none without it.
  const json discovery = {
      {"upnpUuid", uuidOf(call.parts.settings.identity)}, {"publicHost", nullptr}, {"publicPort", nullptr}};
  const bool has_camera = call.parts.desk.snapshot().has_camera;
  return jsonAnswer(200, {{"api", {{"enabled", true}, {"allowCrossOrigin", false}}},
                          {"appearance", {{"name", "Lamina"}, {"color", "default"}}},
                          {"feature", {{"sdSupport", false}, {"modelSizeDetection", false}}},
                          {"folder", json::object()},
                          {"plugins", {{"discovery", discovery}}},
                          {"serial", json::object()},
                          {"server", json::object()},
                          {"temperature", {{"profiles", json::array()}}},
                          {"webcam",
                           {{"webcamEnabled", has_camera},
                            {"streamUrl", has_camera ? "/api/v1/camera" : ""},
                            {"snapshotUrl", ""},
                            {"flipH", false},
                            {"flipV", false},
                            {"rotate90", false}}}});
}

WebResponse getProfiles(SiteCall& /*call*/) {
  return jsonAnswer(200, {{"profiles",
                           {{"_default",
                             {{"id", "_default"},
                              {"name", "Lamina"},
                              {"color", "default"},
                              {"model", "Lamina cell"},
                              {"default", true},
                              {"current", true},
                              {"resource", "/api/printerprofiles/_default"},
                              {"heatedBed", true},
                              {"heatedChamber", false},
                              {"extruder", {{"count", 1}}}}}}}});
}

json flagsOf(const Mapped& state, const CellSnapshot& seen) {
  const std::string text = state.text;
  const UnitState unit = seen.unit.state;
  const bool is_resuming = unit == UnitState::Unholding || unit == UnitState::Unsuspending;
  return {{"operational", !state.is_error},
          {"printing", state.is_printing},
          {"paused", state.is_paused},
          {"pausing", text == "Pausing"},
          {"resuming", is_resuming && !state.is_error},
          {"finishing", unit == UnitState::Completing && !state.is_error},
          {"cancelling", text == "Cancelling"},
          {"ready", state.is_ready},
          {"error", state.is_error},
          {"closedOrError", state.is_error},
          {"sdReady", false}};
}

WebResponse getPrinter(SiteCall& call) {
  const CellSnapshot seen = call.parts.desk.snapshot();
  const Mapped state = stateOf(seen, call.now);
  const ShownMachine machine = presentMachine(seen, call.now);
  const auto heater = [](double actual, double target) {
    return json{{"actual", actual}, {"target", target}, {"offset", 0}};
  };
  json printer = {{"state", {{"text", state.text}, {"flags", flagsOf(state, seen)}}},
                  {"temperature",
                   {{"tool0", heater(machine.nozzle_degc, machine.nozzle_target_degc)},
                    {"bed", heater(machine.bed_degc, machine.bed_target_degc)}}},
                  {"sd", {{"ready", false}}}};
  const auto excluded = call.admitted.target.query.find("exclude");
  if (excluded == call.admitted.target.query.end()) return jsonAnswer(200, printer);
  std::string parts = excluded->second;
  std::replace(parts.begin(), parts.end(), ',', ' ');
  for (const std::string& part : splitIntoWords(parts)) printer.erase(part);
  return jsonAnswer(200, printer);
}

/// A job's program as a file. Neither size nor date are told by the cell.
json fileJson(const std::string& name) {
  return {{"name", name},      {"display", name}, {"path", name},
          {"origin", "local"}, {"size", nullptr}, {"date", nullptr}};
}

WebResponse getPrintJob(SiteCall& call) {
  const CellSnapshot seen = call.parts.desk.snapshot();
  std::optional<LeftEstimate> left;
  {
    const std::lock_guard<std::mutex> lock(call.parts.history_mutex);
    left = call.parts.history.left();
  }
  const bool has_job = seen.unit.job.has_value();
  json file = fileJson(seen.unit.job ? seen.unit.job->name : "");
  if (!has_job) file["name"] = file["display"] = file["path"] = file["origin"] = nullptr;
  // Without a time that is gone Cura shows no progress at all.
  const double gone_s = std::max(0.0, std::round(seen.unit.elapsed_s));
  const json left_s = left ? json(std::round(left->seconds)) : json(nullptr);
  const json whole_s = left && has_job ? json(gone_s + std::round(left->seconds)) : json(nullptr);
  return jsonAnswer(200, {{"job",
                           {{"file", file},
                            {"estimatedPrintTime", whole_s},
                            {"averagePrintTime", nullptr},
                            {"lastPrintTime", nullptr},
                            {"filament", nullptr}}},
                          {"progress",
                           {{"completion", has_job ? json(seen.unit.fraction * 100.0) : json(nullptr)},
                            {"filepos", nullptr},
                            {"printTime", has_job ? json(gone_s) : json(nullptr)},
                            {"printTimeLeft", left_s},
                            {"printTimeLeftOrigin", left ? json("linear") : json(nullptr)}}},
                          {"state", stateOf(seen, call.now).text}});
}

std::string placeOf(const std::string& name) { return "/api/files/local/" + percentEncoded(name, "-._~"); }

/// The queue as files, for who may see it.
json filesJson(const SiteCall& call) {
  json files = json::array();
  if (!mayDo(*call.who().role, WebRight::SeeAll)) return files;
  for (const ShownJob& job : call.parts.desk.snapshot().queue) {
    json file = fileJson(job.name);
    file["type"] = "machinecode";
    file["typePath"] = {"machinecode", "gcode"};
    file["refs"] = {{"resource", placeOf(job.name)}};
    files.push_back(std::move(file));
  }
  return files;
}

WebResponse getFiles(SiteCall& call) {
  return jsonAnswer(200, {{"files", filesJson(call)}, {"free", nullptr}});
}

WebResponse getQueuedFile(SiteCall& call) {
  for (const json& file : filesJson(call))
    if (file["name"] == call.value(0)) return jsonAnswer(200, file);
  return errorAnswer(404, "unknown", "no job of the queue is called '" + call.value(0) + "'");
}

WebResponse getConnection(SiteCall& call) {
  json profiles = json::array();
  profiles.push_back({{"name", "Lamina"}, {"id", "_default"}});
  return jsonAnswer(200, {{"current",
                           {{"state", stateOf(call.parts.desk.snapshot(), call.now).text},
                            {"port", nullptr},
                            {"baudrate", nullptr},
                            {"printerProfile", "_default"}}},
                          {"options",
                           {{"ports", json::array()},
                            {"baudrates", json::array()},
                            {"printerProfiles", profiles},
                            {"portPreference", nullptr},
                            {"baudratePreference", nullptr},
                            {"printerProfilePreference", "_default"},
                            {"autoconnect", true}}}});
}

bool isWanted(const ReceivedUpload& upload, const char* field) {
  const auto found = upload.fields.find(field);
  return found != upload.fields.end() && (found->second == "true" || found->second == "1");
}

bool isInUse(const CellSnapshot& seen, const std::string& name) {
  return seen.unit.job && seen.unit.job->name == name && seen.unit.state != UnitState::Idle &&
         seen.unit.state != UnitState::Complete && seen.unit.state != UnitState::Stopped;
}

WebResponse addFile(SiteCall& call) {
  const ReceivedUpload& upload = call.request.upload;
  const std::string note = "upload '" + upload.name + "'";
  const std::string source = "octoprint: " + call.who().name;
  if (isInUse(call.parts.desk.snapshot(), upload.name)) {
    WebResponse refused = errorAnswer(409, "in_use", "'" + upload.name + "' is being printed");
    refused.note = note;
    return refused;
  }
  const DeskAnswer answer = enqueueUpload(call, source);
  if (answer.outcome != DeskAnswer::Outcome::Done) {
    WebResponse refused = orderAnswer(call, answer);
    refused.note = note;
    return refused;
  }
  const bool is_released = isWanted(upload, "print") &&
                           call.parts.settings.upload_print == UploadPrint::Release &&
                           mayDo(*call.who().role, WebRight::Operate) &&
                           call.parts.desk.changeQueue(QueueChange::Release, answer.job, source).outcome ==
                               DeskAnswer::Outcome::Done;
  const std::string place = placeOf(upload.name);
  WebResponse response = jsonAnswer(
      201, {{"files",
             {{"local",
               {{"name", upload.name},
                {"path", upload.name},
                {"origin", "local"},
                {"refs", {{"resource", place}}}}}}},
            {"done", true},
            {"effectiveSelect", false},
            {"effectivePrint", false},
            {"lamina", {{"job", answer.job}, {"sha256", upload.sha256}, {"is_released", is_released}}}});
  // Cura's plug-in reads where the file is, and breaks off where that is not said.
  response.headers.emplace_back("Location", place);
  response.note = note + " as job " + std::to_string(answer.job) + (is_released ? ", released" : "");
  return response;
}

/// Cura selects what it has sent while another job was printed. Here it waits in the queue already.
WebResponse selectFile(SiteCall& call) {
  const json body = bodyObject(call);
  const std::string word = textOf(body, "command");
  if (word != "select") throw InvalidInput("command is '" + word + "'; expected select");
  const auto print = body.find("print");
  if (print != body.end() && *print == json(true))
    return errorAnswer(409, "not_from_here", "a job is released and started at the cell, and waits for it");
  WebResponse response;
  response.status = 204;
  response.note = "select";
  return response;
}

/// What lets a paused unit go on, by what it has been paused for.
UnitCommand continuing(UnitState state) {
  return state == UnitState::Suspended ? UnitCommand::Unsuspend : UnitCommand::Unhold;
}

UnitCommand commandOf(const json& body, const CellSnapshot& seen) {
  const std::string word = textOf(body, "command");
  if (word == "start") return UnitCommand::Start;
  if (word == "cancel") return UnitCommand::Stop;
  if (word != "pause") throw InvalidInput("command is '" + word + "'; expected start, cancel or pause");
  const std::string action = textOf(body, "action");
  if (action == "pause") return UnitCommand::Hold;
  if (action == "resume") return continuing(seen.unit.state);
  if (!action.empty() && action != "toggle")
    throw InvalidInput("action is '" + action + "'; expected pause, resume or toggle");
  return mapped(seen.unit.state).is_paused ? continuing(seen.unit.state) : UnitCommand::Hold;
}

WebResponse commandJob(SiteCall& call) {
  DeskCommand command;
  command.command = commandOf(bodyObject(call), call.parts.desk.snapshot());
  command.source = "octoprint: " + call.who().name;
  if (command.command != UnitCommand::Hold && !mayDo(*call.who().role, WebRight::Operate))
    return errorAnswer(403, "wrong_role", "a viewer may hold, and give no other command");
  const DeskAnswer answer = call.parts.desk.command(command);
  WebResponse response = orderAnswer(call, answer);
  if (answer.outcome == DeskAnswer::Outcome::Done) {
    response.status = 204;
    response.body.clear();
  }
  response.note = toString(command.command);
  return response;
}

WebResponse refuseGcode(SiteCall& /*call*/) {
  return errorAnswer(403, "no_raw_gcode", "commands of the machine are not taken from the network");
}

WebResponse refuseConnecting(SiteCall& /*call*/) {
  return errorAnswer(
      403, "not_from_here",
      "the cell opens and closes the link to its machine itself; after a lost link give Clear");
}

WebResponse probeKeys(SiteCall& /*call*/) {
  WebResponse response;
  response.status = 204;
  return response;
}

WebResponse requestKey(SiteCall& call) {
  const std::string application = textOf(bodyObject(call), "app");
  if (application.empty()) throw InvalidInput("app is missing; expected the name of the application");
  const std::string secret =
      call.parts.access.requestKey(application, call.request.head.peer.address, call.now);
  if (secret.empty()) return errorAnswer(429, "too_many", "too many applications wait for an answer");
  WebResponse response = jsonAnswer(201, {{"app_token", secret}});
  response.headers.emplace_back("Location", "/plugin/appkeys/request/" + secret);
  response.note = "application '" + application.substr(0, 60) + "' asks for a token";
  return response;
}

WebResponse getKey(SiteCall& call) {
  const WebAccess::KeyDecision decision = call.parts.access.keyDecision(call.value(0), call.now);
  if (!decision.is_known || (decision.key && decision.key->empty()))
    return errorAnswer(404, "unknown", "the request was denied, has expired, or was never made");
  if (!decision.key) return jsonAnswer(202, {{"message", "Awaiting decision"}});
  return jsonAnswer(200, {{"api_key", *decision.key}});
}

}  // namespace

std::vector<SiteRoute> octoprintRoutes() {
  using Body = RouteBody;
  constexpr HttpMethod kGet = HttpMethod::Get;
  constexpr HttpMethod kPost = HttpMethod::Post;
  return {
      {{kGet, "/api/version", WebRight::SeeState, Body::None}, getVersion},
      {{kGet, "/api/server", WebRight::SeeState, Body::None}, getServer},
      {{kPost, "/api/login", WebRight::SeeState, Body::Small}, login},
      {{kGet, "/api/currentuser", WebRight::SeeState, Body::None}, getCurrentUser},
      {{kGet, "/api/settings", WebRight::SeeState, Body::None}, getSettings},
      {{kGet, "/api/printerprofiles", WebRight::SeeState, Body::None}, getProfiles},
      {{kGet, "/api/printer", WebRight::SeeState, Body::None}, getPrinter},
      {{kGet, "/api/job", WebRight::SeeState, Body::None}, getPrintJob},
      {{kPost, "/api/job", WebRight::Hold, Body::Small}, commandJob},
      {{kGet, "/api/connection", WebRight::SeeState, Body::None}, getConnection},
      {{kPost, "/api/connection", WebRight::None, Body::Small}, refuseConnecting},
      {{kGet, "/api/files", WebRight::SeeState, Body::None}, getFiles},
      {{kGet, "/api/files/local", WebRight::SeeState, Body::None}, getFiles},
      {{kGet, "/api/files/local/{name}", WebRight::SeeState, Body::None}, getQueuedFile},
      {{kPost, "/api/files/local", WebRight::Upload, Body::Upload}, addFile},
      {{kPost, "/api/files/local/{name}", WebRight::Upload, Body::Small}, selectFile},
      {{kPost, "/api/printer/command", WebRight::None, Body::Small}, refuseGcode},
      {{kGet, "/plugin/appkeys/probe", WebRight::None, Body::None}, probeKeys},
      {{kPost, "/plugin/appkeys/request", WebRight::None, Body::Small}, requestKey},
      {{kGet, "/plugin/appkeys/request/{secret}", WebRight::None, Body::None}, getKey},
  };
}

}  // namespace lamina
