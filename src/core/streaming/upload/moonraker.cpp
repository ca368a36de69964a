// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <sstream>
#include <utility>

#include "streaming/job/complaints.hpp"
#include "streaming/upload/new_entries.hpp"
#include "streaming/upload/server_answers.hpp"

namespace lamina {
namespace {

// Of the last messages; all are asked for where none of these is known, as many as Moonraker keeps.
constexpr int kFewMessages = 50;
constexpr int kAllMessages = 1000;

/// Klipper behind Moonraker [Moonraker's documentation, "External API"].
class Moonraker final : public PrintServer {
 public:
  using PrintServer::PrintServer;

  const char* firmware() const override { return "klipper"; }
  std::optional<HttpRequest> request(UploadStep step) override;
  ServerAnswer read(UploadStep step, const HttpResponse& response) override;
  ChangeCommand changed(const LiveChange& change) const override;
  std::string emergencyStop() const override {
    return "POST /printer/emergency_stop, or stream.emergency_stop unconfirmed";
  }

 private:
  /// What a report asks next.
  enum class Part : std::uint8_t { Machine, Messages };

  std::optional<HttpRequest> plainRequest(UploadStep step) const;
  HttpRequest post(const std::string& target) const;
  HttpRequest report();
  HttpRequest query() const;
  HttpRequest upload() const;
  HttpRequest cancel();
  ServerAnswer readConnect(const HttpResponse& response);
  ServerAnswer readReport(const HttpResponse& response);
  ServerAnswer readMessages(const HttpResponse& response);
  ServerAnswer readVerify(const HttpResponse& response);
  void readMachine(const nlohmann::json& status);
  void readHeaters(const nlohmann::json& status, AnswerNumbers& numbers);

  bool gives_key_ = false;
  bool knows_size_ = false;  ///< and the file is to be read back
  bool has_asked_to_cancel_ = false;
  bool excludes_parts_ = false;  ///< it can leave out parts
  Part part_ = Part::Machine;
  bool is_asked_ = false;  ///< the part; an answer is to come
  int messages_ = kFewMessages;
  NewEntries said_;
  std::vector<std::string> heaters_;  ///< as the machine lists them
};

bool isList(const nlohmann::json& tree, const char* path) {
  const nlohmann::json::json_pointer pointer(path);
  return tree.contains(pointer) && tree.at(pointer).is_array();
}

constexpr auto kReplaced = nlohmann::json::error_handler_t::replace;
constexpr const char* kGivenBoundary = "lamina-7d1c52b09f3e4a68b1";

std::optional<HttpRequest> Moonraker::request(UploadStep step) {
  if (step == UploadStep::Cancel) return cancel();
  if (step == UploadStep::Upload) knows_size_ = false;
  auto request = step == UploadStep::Report ? report() : plainRequest(step);
  if (request && gives_key_) request->headers.emplace_back("X-Api-Key", order().credential);
  return request;
}

std::optional<HttpRequest> Moonraker::plainRequest(UploadStep step) const {
  const std::string escaped = escapedForUrl(printedFile());
  switch (step) {
    case UploadStep::Connect:
      return HttpRequest{"GET", "/server/info"};
    case UploadStep::Upload:
      return upload();
    case UploadStep::Verify: {
      HttpRequest request{"GET", "/server/files/gcodes/" + escaped};
      request.digests_answer = true;
      request.timeout_s = order().upload_timeout_s;
      return knows_size_ ? request : HttpRequest{"GET", "/server/files/metadata?filename=" + escaped};
    }
    case UploadStep::Start:
      return post("/printer/print/start?filename=" + escaped);
    case UploadStep::Pause:
      return post("/printer/print/pause");
    case UploadStep::Resume:
      return post("/printer/print/resume");
    case UploadStep::HeatersOff:
      return post("/printer/gcode/script?script=" +
                  escapedForUrl(otherOutputsOff() + "TURN_OFF_HEATERS\nM107"));
    case UploadStep::Remove: {
      HttpRequest request = post("/server/files/gcodes/" + escaped);
      request.method = "DELETE";
      return request;
    }
    case UploadStep::Change:
      return post("/printer/gcode/script?script=" + escapedForUrl(given_command));
    case UploadStep::EmergencyStop:
      return post("/printer/emergency_stop");
    default:
      return std::nullopt;
  }
}

/// How machine and print stand, then what the machine has said. A part that was not answered begins anew.
HttpRequest Moonraker::report() {
  if (std::exchange(is_asked_, true)) part_ = Part::Machine;
  if (part_ == Part::Machine) return query();
  return {"GET", "/server/gcode_store?count=" + std::to_string(messages_)};
}

HttpRequest Moonraker::post(const std::string& target) const {
  HttpRequest request{"POST", target};
  request.timeout_s = order().command_timeout_s;
  return request;
}

HttpRequest Moonraker::query() const {
  std::string target =
      "/printer/objects/query?webhooks&print_stats&virtual_sdcard&idle_timeout&gcode_move&heaters&extruder&"
      "heater_bed&toolhead=stalls&exclude_object=excluded_objects";
  for (const std::string& heater : heaters_)
    if (heater != "extruder" && heater != "heater_bed") target += "&" + escapedForUrl(heater);
  return {"GET", target};
}

HttpRequest Moonraker::upload() const {
  const std::string boundary = std::string("--") + kGivenBoundary;
  const auto field = [&](const std::string& name, const std::string& value) {
    return boundary + "\r\nContent-Disposition: form-data; name=\"" + name + "\"\r\n\r\n" + value + "\r\n";
  };
  const std::size_t slash = printedFile().rfind('/');
  HttpRequest request{"POST", "/server/files/upload"};
  request.headers.emplace_back("Content-Type",
                               std::string("multipart/form-data; boundary=") + kGivenBoundary);
  request.head = field("root", "gcodes") + field("path", printedFile().substr(0, slash)) +
                 field("checksum", order().body.sha256()) + boundary +
                 "\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" +
                 printedFile().substr(slash + 1) + "\"\r\nContent-Type: application/octet-stream\r\n\r\n";
  request.sends_program = true;
  request.tail = "\r\n" + boundary + "--\r\n";
  request.timeout_s = order().upload_timeout_s;
  return request;
}

/// CANCEL_PRINT ends only what PAUSE has paused. A print that was paused otherwise, as by an error in the
/// middle of a command, is ended by closing its file.
HttpRequest Moonraker::cancel() {
  const bool is_stuck = has_asked_to_cancel_ && last_report.state == PrintState::Paused;
  HttpRequest request =
      post(is_stuck ? "/printer/gcode/script?script=SDCARD_RESET_FILE" : "/printer/print/cancel");
  if (gives_key_) request.headers.emplace_back("X-Api-Key", order().credential);
  has_asked_to_cancel_ = true;
  return request;
}

ServerAnswer Moonraker::read(UploadStep step, const HttpResponse& response) {
  constexpr int kUnauthorised = 401;
  if (step == UploadStep::Connect) return readConnect(response);
  if (response.status == kUnauthorised)
    return refused("Moonraker does not take this key any more: " + errorTextOf(response));
  switch (step) {
    case UploadStep::Report:
      is_asked_ = false;
      return part_ == Part::Machine ? readReport(response) : readMessages(response);
    case UploadStep::Verify:
      return readVerify(response);
    case UploadStep::Upload:
      return isSuccess(response) ? answered(AnswerKind::Done) : answerOfStatus("the upload", response);
    case UploadStep::Start:
      return isSuccess(response) ? answered(AnswerKind::Done)
                                 : answerOfStatus("the start of the print", response);
    default:
      return isSuccess(response) ? answered(AnswerKind::Done) : answerOfStatus("the command", response);
  }
}

ServerAnswer Moonraker::readConnect(const HttpResponse& response) {
  constexpr int kUnauthorised = 401;
  const auto tree = jsonOf(response);
  if (response.status == kUnauthorised && tree && tree->contains("error")) {
    if (!gives_key_ && !order().credential.empty()) {
      gives_key_ = true;
      return answered(AnswerKind::More);
    }
    return refused(gives_key_ ? "Moonraker does not take the key of stream.password_file"
                              : "Moonraker asks for an API key; expected one in stream.password_file");
  }
  if (response.status / 100 == 5) return answerOfStatus("the question who is there", response);
  if (!tree || !tree->contains(nlohmann::json::json_pointer("/result/klippy_state")))
    return answered(AnswerKind::NotMine);
  const std::uint64_t line = order().body.lineNotUtf8();
  if (line > 0) {
    return {AnswerKind::Refused,
            {ErrorCode::InvalidProgram, order().body.program().name() + " line " + std::to_string(line) +
                                            " is not UTF-8, at which Klipper stops reading a file"}};
  }
  server_name = "Klipper (Moonraker " + valueAt<std::string>(*tree, "/result/moonraker_version", "?") + ")";
  return answered(AnswerKind::Done);
}

ServerAnswer Moonraker::readReport(const HttpResponse& response) {
  constexpr int kNotFound = 404;
  // Moonraker that has just been started knows no such question before it has found Klipper.
  if (response.status == kNotFound)
    return {AnswerKind::Later, {ErrorCode::DeviceError, "Moonraker has not found Klipper yet"}};
  const auto tree = jsonOf(response);
  if (!isSuccess(response)) return answerOfStatus("the question how the printer stands", response);
  const nlohmann::json::json_pointer place("/result/status");
  if (!tree || !tree->contains(place))
    return {AnswerKind::Later,
            {ErrorCode::DeviceError, "the answer of how the printer stands cannot be read"}};
  const nlohmann::json& status = tree->at(place);
  last_report = {};
  const std::string host = valueAt<std::string>(status, "/webhooks/state", "startup");
  last_report.is_ready = host == "ready";
  last_report.is_halted = host == "shutdown" || host == "error";
  last_report.condition =
      valueAt<std::string>(status, "/webhooks/state_message", "Klipper is in the state " + host);
  last_report.condition = last_report.condition.substr(0, last_report.condition.find('\n'));
  const std::string print = valueAt<std::string>(status, "/print_stats/state", "standby");
  last_report.file = valueAt<std::string>(status, "/print_stats/filename", "");
  if (print == "printing") last_report.state = PrintState::Printing;
  if (print == "paused") last_report.state = PrintState::Paused;
  if (print == "complete") last_report.state = PrintState::Complete;
  if (print == "cancelled") last_report.state = PrintState::Stopped;
  if (print == "error") {
    last_report.state = PrintState::Failed;
    last_report.condition = valueAt<std::string>(status, "/print_stats/message", "");
    std::replace(last_report.condition.begin(), last_report.condition.end(), '\n', ' ');
  }
  readMachine(status);
  part_ = Part::Messages;
  messages_ = kFewMessages;
  return answered(AnswerKind::More);
}

/// A server that does not give them leaves the report as it is.
ServerAnswer Moonraker::readMessages(const HttpResponse& response) {
  part_ = Part::Machine;
  const auto tree = jsonOf(response);
  const nlohmann::json::json_pointer place("/result/gcode_store");
  if (!isSuccess(response) || !tree || !tree->contains(place) || !tree->at(place).is_array())
    return answered(AnswerKind::Done);
  const nlohmann::json& store = tree->at(place);
  std::vector<std::string> keys;
  for (const nlohmann::json& entry : store) keys.push_back(entry.dump(-1, ' ', false, kReplaced));
  if (messages_ < kAllMessages && !said_.isKnownIn(keys)) {
    part_ = Part::Messages;
    messages_ = kAllMessages;
    return answered(AnswerKind::More);
  }
  for (std::size_t i = said_.takeNew(keys); i < store.size(); ++i) {
    if (!store[i].is_object() || valueAt<std::string>(store[i], "/type", "") != "response") continue;
    std::istringstream lines(valueAt<std::string>(store[i], "/message", ""));
    for (std::string line; std::getline(lines, line);) {
      if (klipperComplaint(line) != Complaint::None) complaints.push_back(line);
    }
  }
  return answered(AnswerKind::Done);
}

ChangeCommand Moonraker::changed(const LiveChange& change) const {
  if (change.setting == LiveSetting::CancelPart && !excludes_parts_)
    return {"", "this Klipper leaves out no parts: its configuration has no [exclude_object]"};
  return klipperChange(change, order().body.program());
}

/// Klipper answers for every object that is asked for: one that it has not is empty, and what was asked of it
/// null.
void Moonraker::readMachine(const nlohmann::json& status) {
  AnswerNumbers numbers(status);
  last_report.bytes_read = numbers.at<std::uint64_t>("/virtual_sdcard/file_position");
  excludes_parts_ = isList(status, "/exclude_object/excluded_objects");
  last_report.stalls = numbers.at<std::uint64_t>("/toolhead/stalls");
  last_report.is_moving = valueAt<std::string>(status, "/idle_timeout/state", "") == "Printing";
  const auto x = numbers.at<double>("/gcode_move/gcode_position/0");
  const auto y = numbers.at<double>("/gcode_move/gcode_position/1");
  const auto z = numbers.at<double>("/gcode_move/gcode_position/2");
  const auto e = numbers.at<double>("/gcode_move/gcode_position/3");
  if (x && y && z && e) last_report.position = ReportedPosition{*x, *y, *z, *e};
  if (const auto nozzle_c = numbers.at<double>("/extruder/temperature")) {
    ReportedTemperatures now;
    now.nozzle_c = *nozzle_c;
    now.nozzle_target_c = numbers.at<double>("/extruder/target");
    now.bed_c = numbers.at<double>("/heater_bed/temperature");
    now.bed_target_c = numbers.at<double>("/heater_bed/target");
    last_report.temperatures = now;
  }
  readHeaters(status, numbers);
  last_report.doubt = numbers.doubted();
}

/// A heater that is not known to be off counts as one that may be on.
void Moonraker::readHeaters(const nlohmann::json& status, AnswerNumbers& numbers) {
  constexpr const char* kListed = "/heaters/available_heaters";
  const nlohmann::json::json_pointer listed(kListed);
  heaters_.clear();
  const bool is_listed = isList(status, kListed);
  if (is_listed)
    for (const auto& heater : status.at(listed))
      if (heater.is_string()) heaters_.push_back(heater.get<std::string>());
  last_report.has_targets = std::any_of(heaters_.begin(), heaters_.end(), [&](const std::string& heater) {
    return !status.contains(heater) || valueAt(status.at(heater), "/target", 1.0) > 0.0;
  });
  if (is_listed || !status.contains(listed) || status.at(listed).is_null()) return;
  last_report.has_targets = true;
  numbers.doubt(kListed, "a list");
}

ServerAnswer Moonraker::readVerify(const HttpResponse& response) {
  constexpr int kNoMetadata = 404;
  if (response.status == kNoMetadata && !knows_size_) {
    knows_size_ = true;  // by what is read back
    return answered(AnswerKind::More);
  }
  if (!isSuccess(response)) return answerOfStatus("the question what was stored", response);
  if (knows_size_) return compared(order().body, response);
  const auto tree = jsonOf(response);
  if (!tree)
    return {AnswerKind::Later, {ErrorCode::DeviceError, "the answer of what was stored cannot be read"}};
  ServerAnswer size = comparedSize(order().body, *tree, "/result/size");
  if (size.kind != AnswerKind::Done) return size;
  knows_size_ = true;
  return answered(AnswerKind::More);
}

}  // namespace

std::unique_ptr<PrintServer> makeMoonraker(std::shared_ptr<const UploadOrder> order) {
  return std::make_unique<Moonraker>(std::move(order));
}

}  // namespace lamina
