// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>
#include <utility>

#include "streaming/upload/duet_model.hpp"
#include "streaming/upload/server_answers.hpp"

namespace lamina {
namespace {

constexpr std::array<const char*, 4> kModelKeys = {"state", "job", "heat", "move"};

/// A Duet that runs RepRapFirmware alone [RepRapFirmware's documentation, "HTTP requests"].
class Duet final : public PrintServer {
 public:
  using PrintServer::PrintServer;

  const char* firmware() const override { return "reprapfirmware"; }
  std::optional<HttpRequest> request(UploadStep step) override;
  ServerAnswer read(UploadStep step, const HttpResponse& response) override;
  ChangeCommand changed(const LiveChange& change) const override { return reprapChange(change); }

 private:
  /// What a step of several requests asks next.
  enum class Part : std::uint8_t { Session, Tools, Model, Reply };

  HttpRequest get(const std::string& target) const;
  HttpRequest code(const std::string& commands) const;
  HttpRequest upload() const;
  HttpRequest connect() const;
  HttpRequest query() const;
  ServerAnswer readConnect(const HttpResponse& response);
  ServerAnswer readTools(const HttpResponse& response);
  ServerAnswer readModel(const HttpResponse& response);
  ServerAnswer readReply(const HttpResponse& response);
  ServerAnswer readResult(UploadStep step, const HttpResponse& response) const;

  Part part_ = Part::Session;
  bool gives_password_ = false;
  bool has_finished_ = false;  ///< the board has said so
  std::string session_key_;
  nlohmann::json tools_ = nlohmann::json::array();
  nlohmann::json model_;
  std::size_t key_ = 0;
};

std::string onCard(const std::string& file) { return "0:/gcodes/" + file; }

/// Whether the answer to "connect" is a Duet's.
bool isOfDuet(const std::optional<nlohmann::json>& tree) { return tree && tree->contains("err"); }

std::optional<HttpRequest> Duet::request(UploadStep step) {
  const std::string escaped = escapedForUrl(onCard(printedFile()));
  switch (step) {
    case UploadStep::Connect:
      return connect();
    case UploadStep::Report:
      return query();
    case UploadStep::Upload:
      return upload();
    case UploadStep::Verify:
      return get("/rr_fileinfo?name=" + escaped);
    case UploadStep::Start:
      return code("M32 \"" + onCard(printedFile()) + "\"");
    case UploadStep::Pause:
      return code("M25");
    case UploadStep::Resume:
      return code("M24");
    case UploadStep::Cancel:
      return code(cancelCommand(last_report.state));
    case UploadStep::HeatersOff:
      return code(otherOutputsOff() + heatersOffCommands(tools_));
    case UploadStep::Remove:
      return get("/rr_delete?name=" + escaped);
    case UploadStep::Disconnect:
      return get("/rr_disconnect");
    case UploadStep::Change:
      return code(given_command);
    case UploadStep::EmergencyStop:
      break;
  }
  return std::nullopt;
}

HttpRequest Duet::get(const std::string& target) const {
  HttpRequest request{"GET", target};
  request.timeout_s = order().command_timeout_s;
  if (!session_key_.empty()) request.headers.emplace_back("X-Session-Key", session_key_);
  return request;
}

HttpRequest Duet::code(const std::string& commands) const {
  return get("/rr_gcode?gcode=" + escapedForUrl(commands));
}

HttpRequest Duet::connect() const {
  if (part_ == Part::Tools) return get("/rr_model?key=tools&flags=v");
  return {"GET", "/rr_connect?password=" + escapedForUrl(gives_password_ ? order().credential : "") +
                     "&sessionKey=yes"};
}

HttpRequest Duet::query() const {
  if (part_ == Part::Reply) return get("/rr_reply");
  return get(std::string("/rr_model?key=") + kModelKeys[key_] + "&flags=v");
}

HttpRequest Duet::upload() const {
  std::array<char, 9> crc{};
  std::snprintf(crc.data(), crc.size(), "%08x", order().body.crc32());
  HttpRequest request =
      get("/rr_upload?name=" + escapedForUrl(onCard(printedFile())) + "&crc32=" + crc.data());
  request.method = "POST";
  request.sends_program = true;
  request.timeout_s = order().upload_timeout_s;
  return request;
}

ServerAnswer Duet::read(UploadStep step, const HttpResponse& response) {
  constexpr int kUnauthorised = 401;
  if (step == UploadStep::Connect) return part_ == Part::Tools ? readTools(response) : readConnect(response);
  if (response.status == kUnauthorised) {
    part_ = Part::Session;
    session_key_.clear();
    return answered(AnswerKind::LoggedOut);
  }
  if (step == UploadStep::Report) return part_ == Part::Reply ? readReply(response) : readModel(response);
  if (step == UploadStep::Disconnect) return answered(AnswerKind::Done);
  return readResult(step, response);
}

ServerAnswer Duet::readConnect(const HttpResponse& response) {
  constexpr std::size_t kLongestCommand = 255;  // bytes
  if (response.status / 100 == 5) return answerOfStatus("the question who is there", response);
  const auto tree = jsonOf(response);
  if (!isOfDuet(tree)) return answered(AnswerKind::NotMine);
  AnswerNumbers numbers(*tree);
  const auto error = numbers.at<int>("/err");
  const auto key = numbers.at<std::uint64_t>("/sessionKey");
  if (!numbers.doubted().empty()) return unreadable("the question who is there", numbers.doubted());
  if (error == 1 && !gives_password_ && !order().credential.empty()) {
    gives_password_ = true;
    return answered(AnswerKind::More);
  }
  if (error == 1) {
    return refused(gives_password_ ? "the Duet does not take the password of stream.password_file"
                                   : "the Duet asks for a password; expected it in stream.password_file");
  }
  if (error != 0)
    return {AnswerKind::Later,
            {ErrorCode::Rejected, "the Duet has no session left; close others that show it"}};
  const ProgramBody& body = order().body;
  if (body.longestCommand() > kLongestCommand) {
    return {AnswerKind::Refused,
            {ErrorCode::InvalidProgram,
             body.program().name() + " line " + std::to_string(body.longestCommandLine()) + " has " +
                 std::to_string(body.longestCommand()) + " bytes; RepRapFirmware takes " +
                 std::to_string(kLongestCommand)}};
  }
  session_key_ = key.value_or(0) == 0 ? "" : std::to_string(*key);
  server_name = "RepRapFirmware (" + valueAt<std::string>(*tree, "/boardType", "Duet") + ")";
  part_ = Part::Tools;
  return answered(AnswerKind::More);
}

ServerAnswer Duet::readTools(const HttpResponse& response) {
  const auto tree = jsonOf(response);
  if (!isSuccess(response)) return answerOfStatus("the question which tools there are", response);
  if (!tree || !tree->contains("result"))
    return {AnswerKind::Later, {ErrorCode::DeviceError, "the Duet does not report which tools it has"}};
  tools_ = tree->at("result").is_array() ? tree->at("result") : nlohmann::json::array();
  part_ = Part::Model;
  key_ = 0;
  return answered(AnswerKind::Done);
}

ServerAnswer Duet::readModel(const HttpResponse& response) {
  const auto tree = jsonOf(response);
  const std::size_t key = std::exchange(key_, 0);
  if (!isSuccess(response)) return answerOfStatus("the question how the printer stands", response);
  if (!tree || !tree->contains("result") || !tree->at("result").is_object())
    return {AnswerKind::Later,
            {ErrorCode::DeviceError, "the answer of how the printer stands cannot be read"}};
  model_[kModelKeys[key]] = tree->at("result");
  if (key + 1 < kModelKeys.size()) {
    key_ = key + 1;
    return answered(AnswerKind::More);
  }
  last_report = reportOf(model_);
  part_ = Part::Reply;
  return answered(AnswerKind::More);
}

ServerAnswer Duet::readReply(const HttpResponse& response) {
  part_ = Part::Model;
  if (!isSuccess(response)) return answerOfStatus("the question what the printer has said", response);
  // The board says it once; a print of less than a second has no duration to recognise it by.
  if (response.body.find("Finished printing file " + onCard(printedFile())) != std::string::npos)
    has_finished_ = true;
  for (const std::string& line : complaintsIn(response.body)) complaints.push_back(line);
  if (has_finished_ && last_report.state == PrintState::Stopped && isOurs())
    last_report.state = PrintState::Complete;
  return answered(AnswerKind::Done);
}

ServerAnswer Duet::readResult(UploadStep step, const HttpResponse& response) const {
  const std::string what = step == UploadStep::Upload ? "the upload" : "the command";
  if (!isSuccess(response)) return answerOfStatus(what, response);
  const auto tree = jsonOf(response);
  if (!tree)
    return {AnswerKind::Later, {ErrorCode::DeviceError, "the answer to " + what + " cannot be read"}};
  AnswerNumbers numbers(*tree);
  const int error = numbers.at<int>("/err").value_or(0);
  if (!numbers.doubted().empty()) return unreadable(what, numbers.doubted());
  if (step == UploadStep::Verify && error == 0) return comparedSize(order().body, *tree, "/size");
  if (error == 0) return answered(AnswerKind::Done);
  if (step == UploadStep::Upload)
    return refused("the Duet has not stored the file: its size or checksum is wrong, or the card is full");
  if (step == UploadStep::Verify) return refused("the Duet does not find the file that was uploaded");
  return {AnswerKind::NotTaken, {ErrorCode::DeviceError, "the Duet has no room for another command"}};
}

}  // namespace

std::unique_ptr<PrintServer> makeDuet(std::shared_ptr<const UploadOrder> order) {
  return std::make_unique<Duet>(std::move(order));
}

}  // namespace lamina
