// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <utility>

#include "streaming/upload/duet_model.hpp"
#include "streaming/upload/new_entries.hpp"
#include "streaming/upload/server_answers.hpp"

namespace lamina {
namespace {

/// A Duet behind a single-board computer with DuetSoftwareFramework [its documentation, "REST API"].
class DuetWithComputer final : public PrintServer {
 public:
  using PrintServer::PrintServer;

  const char* firmware() const override { return "reprapfirmware"; }
  std::optional<HttpRequest> request(UploadStep step) override;
  ServerAnswer read(UploadStep step, const HttpResponse& response) override;
  ChangeCommand changed(const LiveChange& change) const override { return reprapChange(change); }

 private:
  HttpRequest ask(const std::string& method, const std::string& target) const;
  HttpRequest code(const std::string& commands) const;
  ServerAnswer readConnect(const HttpResponse& response);
  ServerAnswer readModel(const HttpResponse& response);
  void readMessages(const nlohmann::json& model);
  ServerAnswer readCode(UploadStep step, const HttpResponse& response) const;

  bool gives_password_ = false;
  std::string session_key_;
  nlohmann::json tools_ = nlohmann::json::array();
  NewEntries said_;
};

std::optional<HttpRequest> DuetWithComputer::request(UploadStep step) {
  const std::string path = "/machine/file/" + escapedForUrl("gcodes/" + printedFile());
  switch (step) {
    case UploadStep::Connect:
      return HttpRequest{
          "GET", "/machine/connect?password=" + escapedForUrl(gives_password_ ? order().credential : "")};
    case UploadStep::Report:
      return ask("GET", "/machine/model");
    case UploadStep::Upload: {
      HttpRequest request = ask("PUT", path);
      request.sends_program = true;
      request.timeout_s = order().upload_timeout_s;
      return request;
    }
    case UploadStep::Verify: {
      HttpRequest request = ask("GET", path);
      request.digests_answer = true;
      request.timeout_s = order().upload_timeout_s;
      return request;
    }
    case UploadStep::Start:
      return code("M32 \"0:/gcodes/" + printedFile() + "\"");
    case UploadStep::Pause:
      return code("M25");
    case UploadStep::Resume:
      return code("M24");
    case UploadStep::Cancel:
      return code(cancelCommand(last_report.state));
    case UploadStep::HeatersOff:
      return code(otherOutputsOff() + heatersOffCommands(tools_));
    case UploadStep::Remove:
      return ask("DELETE", path);
    case UploadStep::Disconnect:
      return ask("GET", "/machine/disconnect");
    case UploadStep::Change:
      return code(given_command);
    case UploadStep::EmergencyStop:
      break;
  }
  return std::nullopt;
}

HttpRequest DuetWithComputer::ask(const std::string& method, const std::string& target) const {
  HttpRequest request{method, target};
  request.timeout_s = order().command_timeout_s;
  if (!session_key_.empty()) request.headers.emplace_back("X-Session-Key", session_key_);
  return request;
}

HttpRequest DuetWithComputer::code(const std::string& commands) const {
  HttpRequest request = ask("POST", "/machine/code");
  request.headers.emplace_back("Content-Type", "text/plain");
  request.head = commands;
  return request;
}

ServerAnswer DuetWithComputer::read(UploadStep step, const HttpResponse& response) {
  constexpr int kUnauthorised = 401;
  constexpr int kForbidden = 403;
  if (step == UploadStep::Connect) return readConnect(response);
  if (response.status == kUnauthorised || response.status == kForbidden) {
    session_key_.clear();
    return answered(AnswerKind::LoggedOut);
  }
  switch (step) {
    case UploadStep::Report:
      return readModel(response);
    case UploadStep::Upload:
      return isSuccess(response) ? answered(AnswerKind::Done) : answerOfStatus("the upload", response);
    case UploadStep::Verify:
      if (!isSuccess(response)) return answerOfStatus("the question what was stored", response);
      return compared(order().body, response);
    case UploadStep::Remove:
    case UploadStep::Disconnect:
      return isSuccess(response) ? answered(AnswerKind::Done) : answerOfStatus("the command", response);
    default:
      return readCode(step, response);
  }
}

ServerAnswer DuetWithComputer::readConnect(const HttpResponse& response) {
  constexpr int kForbidden = 403;
  if (response.status == kForbidden) {
    if (!gives_password_ && !order().credential.empty()) {
      gives_password_ = true;
      return answered(AnswerKind::More);
    }
    return refused(gives_password_ ? "the Duet does not take the password of stream.password_file"
                                   : "the Duet asks for a password; expected it in stream.password_file");
  }
  if (response.status / 100 == 5) return answerOfStatus("the question who is there", response);
  const auto tree = jsonOf(response);
  session_key_ = tree ? valueAt<std::string>(*tree, "/sessionKey", "") : "";
  if (session_key_.empty()) return answered(AnswerKind::NotMine);
  server_name = "RepRapFirmware (DuetSoftwareFramework)";
  return answered(AnswerKind::Done);
}

ServerAnswer DuetWithComputer::readModel(const HttpResponse& response) {
  const auto tree = jsonOf(response);
  if (!isSuccess(response)) return answerOfStatus("the question how the printer stands", response);
  if (!tree || !tree->contains("state") || !tree->contains("job"))
    return {AnswerKind::Later,
            {ErrorCode::DeviceError, "the answer of how the printer stands cannot be read"}};
  last_report = reportOf(*tree);
  if (tree->contains("tools") && tree->at("tools").is_array()) tools_ = tree->at("tools");
  readMessages(*tree);
  return answered(AnswerKind::Done);
}

/// They stay in the model until a client that subscribes to it, such as Duet Web Control, has taken them.
void DuetWithComputer::readMessages(const nlohmann::json& model) {
  constexpr std::array<const char*, 3> kBeginnings = {"", "Warning: ", "Error: "};
  if (!model.contains("messages") || !model.at("messages").is_array()) return;
  const nlohmann::json& messages = model.at("messages");
  std::vector<std::string> keys;
  for (const nlohmann::json& message : messages)
    keys.push_back(message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  for (std::size_t i = said_.takeNew(keys); i < messages.size(); ++i) {
    if (!messages[i].is_object()) continue;
    const auto type = std::min<std::size_t>(valueAt<std::size_t>(messages[i], "/type", 0), 2);
    const std::string content = valueAt<std::string>(messages[i], "/content", "");
    for (const std::string& line : complaintsIn(kBeginnings[type] + content)) complaints.push_back(line);
  }
}

/// Codes are answered by what they say, an error by a text that begins so.
ServerAnswer DuetWithComputer::readCode(UploadStep step, const HttpResponse& response) const {
  const std::string what = step == UploadStep::Start ? "the start of the print" : "the command";
  if (!isSuccess(response)) return answerOfStatus(what, response);
  if (response.body.compare(0, 6, "Error:") != 0) return answered(AnswerKind::Done);
  return refused(what + " was refused: " + errorTextOf(response));
}

}  // namespace

std::unique_ptr<PrintServer> makeDuetWithComputer(std::shared_ptr<const UploadOrder> order) {
  return std::make_unique<DuetWithComputer>(std::move(order));
}

}  // namespace lamina
