// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/web/mesh_upload.hpp"
#include "lamina/web/order_lane.hpp"
#include "web/site_routes.hpp"

namespace lamina {
namespace {

using nlohmann::json;

constexpr std::int64_t kMostSequence = 4294967295;

WebResponse noted(WebResponse response, const std::string& note) {
  response.note = note;
  return response;
}

WebResponse getState(SiteCall& call) {
  json state = stateJson(call.parts, *call.who().role, call.now);
  state["clock_s"] = call.now.steady_s;
  return jsonAnswer(200, state);
}

WebResponse getAlarms(SiteCall& call) {
  return jsonAnswer(200, {{"alarms", alarmsJson(call.parts.desk.snapshot())}});
}

WebResponse getJobs(SiteCall& call) {
  json jobs = json::array();
  for (const ShownJob& job : call.parts.desk.snapshot().queue) jobs.push_back(jobJson(job));
  return jsonAnswer(200, {{"jobs", jobs}});
}

WebResponse getJob(SiteCall& call) {
  const std::int64_t id = jobNumber(call.value(0));
  for (const ShownJob& job : call.parts.desk.snapshot().queue)
    if (job.id == id) return jsonAnswer(200, jobJson(job));
  return errorAnswer(404, "unknown", "job " + call.value(0) + " is not in the queue");
}

WebResponse addJob(SiteCall& call) {
  const DeskAnswer answer = enqueueUpload(call, call.source());
  const std::string note = "upload '" + call.request.upload.name + "'";
  if (answer.outcome != DeskAnswer::Outcome::Done) return noted(orderAnswer(call, answer), note);
  return noted(jsonAnswer(201, {{"job", answer.job},
                                {"name", call.request.upload.name},
                                {"bytes", call.request.upload.bytes},
                                {"sha256", call.request.upload.sha256}}),
               note + " as job " + std::to_string(answer.job));
}

WebResponse changeJob(SiteCall& call, QueueChange change, const char* word) {
  const DeskAnswer answer = call.parts.desk.changeQueue(change, jobNumber(call.value(0)), call.source());
  return noted(orderAnswer(call, answer), std::string(word) + " job " + call.value(0));
}

WebResponse revokeJob(SiteCall& call) { return changeJob(call, QueueChange::Revoke, "revoke"); }

/// To the place of the body, or to the front if it names none.
WebResponse moveJob(SiteCall& call) {
  const json body = bodyObject(call);
  const auto place = body.find("place");
  if (place == body.end()) return changeJob(call, QueueChange::MoveToFront, "move to the front");
  constexpr std::int64_t kMostPlaces = 1000000;
  if (!place->is_number_integer() || place->get<std::int64_t>() < 1 ||
      place->get<std::int64_t>() > kMostPlaces)
    throw InvalidInput("place is " + place->dump() + "; expected a whole number from 1 to 1000000");
  const std::int64_t number = place->get<std::int64_t>();
  const DeskAnswer answer = call.parts.desk.moveJob(jobNumber(call.value(0)), number, call.source());
  return noted(orderAnswer(call, answer),
               "move job " + call.value(0) + " to place " + std::to_string(number));
}

WebResponse removeJob(SiteCall& call) { return changeJob(call, QueueChange::Remove, "remove"); }

WebResponse getStartup(SiteCall& call) {
  return jsonAnswer(200, {{"startup", startupJson(call.parts.desk.snapshot())}});
}

/// What would let something move is refused if it was pressed too long ago: held up on its way, it would be
/// carried out when whoever pressed may stand at the machine. Without the header nobody says when it was.
std::optional<WebResponse> refusedAsLate(const SiteCall& call, const std::string& what, double most_s) {
  const std::string stated = call.request.head.header("x-pressed-at");
  if (stated.empty()) return std::nullopt;
  const json pressed = json::parse(stated, nullptr, false);
  if (!pressed.is_number())
    throw InvalidInput("X-Pressed-At is '" + stated.substr(0, 40) + "'; expected clock_s of a state, in s");
  const double age_s = call.now.steady_s - pressed.get<double>();
  // Beyond the present it is a time of a host that was started anew since.
  if (std::abs(age_s) <= most_s) return std::nullopt;
  WebResponse refusal = errorAnswer(409, "too_late",
                                    what + " came " + numberText(std::round(age_s * 10.0) / 10.0) +
                                        " s after it was pressed; expected at most " + numberText(most_s) +
                                        " s; nothing was done");
  refusal.note = what;
  return refusal;
}

/// A queue that goes on by itself starts what is released.
WebResponse releaseJob(SiteCall& call) {
  if (const auto late = refusedAsLate(call, "release job " + call.value(0), call.parts.settings.patience_s))
    return *late;
  return changeJob(call, QueueChange::Release, "release");
}

WebResponse runStartup(SiteCall& call) {
  const json body = bodyObject(call);
  const std::string word = textOf(body, "command");
  const std::string step = textOf(body, "step");
  if (word != "run" && word != "confirm" && word != "abort")
    throw InvalidInput("command is '" + word + "'; expected run, confirm or abort");
  const StartupCommand command = word == "run"       ? StartupCommand::Run
                                 : word == "confirm" ? StartupCommand::Confirm
                                                     : StartupCommand::Abort;
  if (command != StartupCommand::Abort)
    if (const auto late = refusedAsLate(call, "start-up: " + word, call.parts.settings.patience_s))
      return *late;
  return noted(orderAnswer(call, call.parts.desk.startup(command, step)), "start-up: " + word + " " + step);
}

WebResponse getLoop(SiteCall& call) {
  const CellSnapshot seen = call.parts.desk.snapshot();
  if (!seen.loop) return errorAnswer(404, "unknown", "no loop on layer heights has been heard of");
  return jsonAnswer(200, {{"state", seen.loop->state},
                          {"reason", seen.loop->reason},
                          {"layer", seen.loop->layer},
                          {"alarm", seen.loop->alarm}});
}

WebResponse setLoop(SiteCall& call) {
  const std::string word = textOf(bodyObject(call), "request");
  if (word != "off" && word != "identify" && word != "active")
    throw InvalidInput("request is '" + word + "'; expected off, identify or active");
  const ShownLoopRequest request = word == "off"        ? ShownLoopRequest::Off
                                   : word == "identify" ? ShownLoopRequest::Identify
                                                        : ShownLoopRequest::Active;
  if (request != ShownLoopRequest::Off)
    if (const auto late = refusedAsLate(call, "loop " + word, call.parts.settings.patience_s)) return *late;
  return noted(orderAnswer(call, call.parts.desk.setLoop(request)), "loop " + word);
}

WebResponse getLayers(SiteCall& call) {
  return jsonAnswer(200, {{"layers", layersJson(call.parts.desk.snapshot())}});
}

WebResponse getDeviation(SiteCall& call) {
  const ShownDeviation shown = call.parts.desk.deviation();
  if (shown.number == 0) return errorAnswer(404, "unknown", "no layer has been measured yet");
  return jsonAnswer(200, {{"number", shown.number},
                          {"columns", shown.columns},
                          {"rows", shown.rows},
                          {"errors_m", shown.errors_m}});
}

WebResponse getPreview(SiteCall& call) {
  const ShownPreview shown = call.parts.desk.preview(static_cast<std::int32_t>(
      std::min<std::int64_t>(wholeNumber(call.value(0)), std::numeric_limits<std::int32_t>::max())));
  if (shown.is_being_read)
    return jsonAnswer(202, {{"is_being_read", true}, {"message", "the program is being read; ask again"}});
  const auto& preview = shown.layer;
  if (!preview) return errorAnswer(404, "unknown", "there is no such layer, or no job");
  return jsonAnswer(200, {{"layer", preview->layer},
                          {"layers", preview->layers},
                          {"z_m", preview->z_m},
                          {"lines", preview->lines},
                          {"is_cut_short", preview->is_cut_short}});
}

WebResponse getCounters(SiteCall& call) {
  const ShownUnit unit = call.parts.desk.snapshot().unit;
  return jsonAnswer(200,
                    {{"parts", unit.parts}, {"defective", unit.defective}, {"running_s", unit.running_s}});
}

WebResponse getHistory(SiteCall& call) {
  const auto from = call.admitted.target.query.find("from");
  const double from_s =
      from == call.admitted.target.query.end() ? 0.0 : static_cast<double>(wholeNumber(from->second));
  json samples = json::array();
  json events = json::array();
  const std::lock_guard<std::mutex> lock(call.parts.history_mutex);
  for (const HistorySample& sample : call.parts.history.samples())
    if (sample.utc_s >= from_s)
      samples.push_back({{"utc_s", sample.utc_s},
                         {"nozzle_degc", sample.nozzle_degc},
                         {"bed_degc", sample.bed_degc},
                         {"fraction", sample.fraction}});
  for (const CellEvent& event : call.parts.history.events())
    if (event.utc_s >= from_s)
      events.push_back(
          {{"number", event.number}, {"utc_s", event.utc_s}, {"kind", event.kind}, {"text", event.text}});
  return jsonAnswer(200, {{"samples", samples}, {"events", events}});
}

UnitCommand commandNamed(const std::string& name) {
  for (const UnitCommand command : unitCommands())
    if (name == toString(command)) return command;
  throw InvalidInput(
      "command is '" + name +
      "'; expected Reset, Start, Stop, Hold, Unhold, Suspend, Unsuspend, Abort, Clear or Complete");
}

int cutOffOf(const json& body) {
  const std::string word = textOf(body, "cut_off");
  if (word.empty()) return 0;
  if (word == "resume") return 1;
  if (word == "discard") return 2;
  throw InvalidInput("cut_off is '" + word + "'; expected resume or discard");
}

/// What somebody has looked at before a resume.
std::vector<std::string> confirmedIn(const json& body) {
  constexpr std::size_t kMost = 16;
  const auto confirmed = body.find("confirmed");
  if (confirmed == body.end() || confirmed->is_null()) return {};
  std::vector<std::string> names;
  const bool is_list = confirmed->is_array() && confirmed->size() <= kMost;
  if (is_list)
    for (const json& name : *confirmed)
      if (name.is_string() && name.get_ref<const std::string&>().size() <= kMost)
        names.push_back(name.get<std::string>());
  if (!is_list || names.size() != confirmed->size())
    throw InvalidInput("confirmed is no list of at most 16 names of steps, of 16 letters each");
  return names;
}

std::optional<double> confirmedPlace(const json& body) {
  const auto begin = body.find("confirmed_begin_mm");
  if (begin == body.end() || begin->is_null()) return std::nullopt;
  if (!begin->is_number() || begin->get<double>() < 0.0)
    throw InvalidInput("confirmed_begin_mm is no length from 0 mm on; expected begin_mm of the step 'place'");
  return begin->get<double>();
}

/// For the audit: what was confirmed, or nothing.
std::string confirmedText(const ResumeConfirmation& confirmed) {
  if (confirmed.steps.empty()) return "";
  const std::string text = "; confirmed: " + listed(confirmed.steps);
  return confirmed.begin_mm ? text + ", from " + numberText(*confirmed.begin_mm) + " mm" : text;
}

WebResponse giveCommand(SiteCall& call) {
  const json body = bodyObject(call);
  DeskCommand command;
  command.command = commandNamed(textOf(body, "command"));
  command.source = call.source();
  command.cut_off = cutOffOf(body);
  command.confirmed = {confirmedIn(body), confirmedPlace(body)};
  if (command.command != UnitCommand::Hold && !mayDo(*call.who().role, WebRight::Operate))
    return errorAnswer(403, "wrong_role", std::string("a viewer may hold, and give no other command"));
  const auto sequence = body.find("if_sequence");
  if (sequence != body.end() && !sequence->is_null()) {
    if (!sequence->is_number_unsigned() || sequence->get<std::uint64_t>() > kMostSequence)
      throw InvalidInput("if_sequence is not a whole number from 0 to 4294967295");
    command.expected_sequence = sequence->get<std::uint32_t>();
  }
  if (!stopsUnit(command.command))
    if (const auto late = refusedAsLate(call, toString(command.command), call.parts.settings.patience_s))
      return *late;
  std::string note = toString(command.command);
  note += confirmedText(command.confirmed);
  return noted(orderAnswer(call, call.parts.desk.command(command)), note);
}

WebResponse setMode(SiteCall& call) {
  const json body = bodyObject(call);
  const auto mode = body.find("mode");
  if (mode == body.end() || !mode->is_number_integer() || mode->get<std::int64_t>() < 1 ||
      mode->get<std::int64_t>() > 31)
    throw InvalidInput("mode is missing or not from 1 to 31; expected 1 (Production), 2 or 3");
  const int number = mode->get<int>();
  return noted(orderAnswer(call, call.parts.desk.changeMode(number, call.source())),
               "mode " + std::to_string(number));
}

WebResponse setRemote(SiteCall& call) {
  const json body = bodyObject(call);
  const auto allowed = body.find("allowed");
  if (allowed == body.end() || !allowed->is_boolean())
    throw InvalidInput("allowed is missing or neither true nor false");
  const PlcAccess access = allowed->get<bool>() ? PlcAccess::Allowed : PlcAccess::Locked;
  return noted(orderAnswer(call, call.parts.desk.setPlcAccess(access, call.source())),
               access == PlcAccess::Allowed ? "commands of the PLC allowed" : "commands of the PLC locked");
}

double finiteNumber(const json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || !found->is_number())
    throw InvalidInput(std::string(key) + " is missing or no number; expected one [m, rad, m/s or rad/s]");
  return found->get<double>();
}

DeskManual::Kind manualKind(const std::string& word) {
  if (word == "take") return DeskManual::Kind::Take;
  if (word == "step") return DeskManual::Kind::Step;
  if (word == "release") return DeskManual::Kind::Release;
  throw InvalidInput("request is '" + word + "'; expected take, step or release");
}

/// Steps that are carried out come several times a second: the audit has who took the machine, and for how
/// long.
WebResponse moveByHand(SiteCall& call) {
  const json body = bodyObject(call);
  const std::string word = textOf(body, "request");
  DeskManual order;
  order.kind = manualKind(word);
  order.who.source = call.source();
  const auto lease = body.find("lease");
  if (lease != body.end() && !lease->is_null()) {
    if (!lease->is_number_unsigned())
      throw InvalidInput("lease is not a whole number from 0 on; expected that of the answer to take");
    order.who.lease = lease->get<std::uint64_t>();
  }
  if (order.kind == DeskManual::Kind::Step) {
    if (const auto late = refusedAsLate(call, "a step by hand", kLatestStep)) return *late;
    order.step = {textOf(body, "frame"), textOf(body, "axis"), finiteNumber(body, "step"),
                  finiteNumber(body, "speed")};
  }
  const DeskAnswer answer = call.parts.desk.moveByHand(order);
  if (answer.outcome != DeskAnswer::Outcome::Done)
    return noted(orderAnswer(call, answer), "by hand: " + word);
  WebResponse response = noted(jsonAnswer(200, {{"lease", answer.lease}}), "by hand: " + word);
  response.is_audited = order.kind != DeskManual::Kind::Step;
  return response;
}

WebResponse acknowledgeAlarm(SiteCall& call) {
  const auto id = wholeNumber(call.value(0));
  if (id > 65535) throw InvalidInput("alarm " + call.value(0) + "; expected at most 65535");
  return noted(orderAnswer(call, call.parts.desk.acknowledge(static_cast<int>(id), call.source())),
               "acknowledge alarm " + call.value(0));
}

/// A queue that goes on by itself starts the next part.
WebResponse confirmRemoval(SiteCall& call) {
  if (const auto late = refusedAsLate(call, "part taken away", call.parts.settings.patience_s)) return *late;
  return noted(orderAnswer(call, call.parts.desk.confirmRemoval(call.source())), "part taken away");
}

WebResponse getMetrics(SiteCall& call) {
  const CellSnapshot seen = call.parts.desk.snapshot();
  const double age_s = seen.heard_s ? call.now.steady_s - *seen.heard_s : -1.0;
  std::ostringstream text;
  const auto line = [&text](const char* name, const char* type, double value) {
    if (std::isfinite(value))
      text << "# TYPE " << name << ' ' << type << '\n' << name << ' ' << value << '\n';
  };
  line("lamina_status_age_seconds", "gauge", age_s);
  line("lamina_unit_state", "gauge", static_cast<double>(seen.unit.state));
  line("lamina_unit_mode", "gauge", seen.unit.mode);
  line("lamina_job_fraction", "gauge", seen.unit.fraction);
  line("lamina_job_layer", "gauge", seen.unit.layer);
  line("lamina_alarms", "gauge", static_cast<double>(seen.alarms.size()));
  line("lamina_queued_jobs", "gauge", static_cast<double>(seen.queue.size()));
  line("lamina_parts_total", "counter", seen.unit.parts);
  line("lamina_defective_parts_total", "counter", seen.unit.defective);
  line("lamina_running_seconds_total", "counter", seen.unit.running_s);
  const ShownMachine machine = presentMachine(seen, call.now);
  line("lamina_nozzle_celsius", "gauge", machine.nozzle_degc);
  line("lamina_bed_celsius", "gauge", machine.bed_degc);
  WebResponse response;
  response.type = "text/plain; version=0.0.4; charset=utf-8";
  response.body = text.str();
  return response;
}

/// Sockets and pictures are not answered here.
WebResponse upgradeOnly(SiteCall& /*call*/) {
  return errorAnswer(400, "no_stream",
                     "this address is a stream; expected a WebSocket or a reader of pictures");
}

}  // namespace

DeskAnswer enqueueUpload(SiteCall& call, const std::string& source) {
  const ReceivedUpload& upload = call.request.upload;
  const auto field = [&upload](const char* name) {
    const auto found = upload.fields.find(name);
    return found == upload.fields.end() ? std::string() : found->second;
  };
  if (!meshSuffix(upload.name).empty()) return call.parts.desk.enqueueMesh(meshOf(upload, source));
  return call.parts.desk.enqueue({upload.path, upload.name, field("part"), source});
}

std::vector<SiteRoute> cellRoutes() {
  using Body = RouteBody;
  constexpr HttpMethod kGet = HttpMethod::Get;
  constexpr HttpMethod kPost = HttpMethod::Post;
  return {
      {{kGet, "/api/v1/state", WebRight::SeeState, Body::None}, getState},
      {{kPost, "/api/v1/commands", WebRight::Hold, Body::Small}, giveCommand},
      {{kGet, "/api/v1/alarms", WebRight::SeeAll, Body::None}, getAlarms},
      {{kPost, "/api/v1/alarms/{id}/acknowledge", WebRight::Operate, Body::Small}, acknowledgeAlarm},
      {{kGet, "/api/v1/jobs", WebRight::SeeAll, Body::None}, getJobs},
      {{kPost, "/api/v1/jobs", WebRight::Upload, Body::Upload}, addJob},
      {{kGet, "/api/v1/jobs/{id}", WebRight::SeeAll, Body::None}, getJob},
      {{HttpMethod::Delete, "/api/v1/jobs/{id}", WebRight::Operate, Body::Small}, removeJob},
      {{kPost, "/api/v1/jobs/{id}/release", WebRight::Operate, Body::Small}, releaseJob},
      {{kPost, "/api/v1/jobs/{id}/revoke", WebRight::Operate, Body::Small}, revokeJob},
      {{kPost, "/api/v1/jobs/{id}/move", WebRight::Operate, Body::Small}, moveJob},
      {{kPost, "/api/v1/removal", WebRight::Operate, Body::Small}, confirmRemoval},
      {{kGet, "/api/v1/startup", WebRight::SeeAll, Body::None}, getStartup},
      {{kPost, "/api/v1/startup", WebRight::Operate, Body::Small}, runStartup},
      {{kGet, "/api/v1/loop", WebRight::SeeAll, Body::None}, getLoop},
      {{kPost, "/api/v1/loop", WebRight::Maintain, Body::Small}, setLoop},
      {{kPost, "/api/v1/mode", WebRight::Maintain, Body::Small}, setMode},
      {{kPost, "/api/v1/remote", WebRight::Maintain, Body::Small}, setRemote},
      {{kPost, "/api/v1/manual", WebRight::Maintain, Body::Small}, moveByHand},
      {{kGet, "/api/v1/layers", WebRight::SeeAll, Body::None}, getLayers},
      {{kGet, "/api/v1/deviation", WebRight::SeeAll, Body::None}, getDeviation},
      {{kGet, "/api/v1/preview/{layer}", WebRight::SeeAll, Body::None}, getPreview},
      {{kGet, "/api/v1/counters", WebRight::SeeAll, Body::None}, getCounters},
      {{kGet, "/api/v1/history", WebRight::SeeAll, Body::None}, getHistory},
      {{kGet, "/api/v1/metrics", WebRight::SeeAll, Body::None}, getMetrics},
      {{kGet, "/api/v1/ws", WebRight::SeeState, Body::Socket}, upgradeOnly},
      {{kGet, "/api/v1/camera", WebRight::SeeAll, Body::Camera}, upgradeOnly},
  };
}

}  // namespace lamina
