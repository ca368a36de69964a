// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/print_server/emulated_duet.hpp"

#include <boost/crc.hpp>
#include <cmath>
#include <sstream>

#include "streaming/emulator/print_server/emulated_print_server.hpp"

namespace lamina {
namespace {

using nlohmann::json;

std::string runCode(EmulatedPrinter& printer, const std::string& code) {
  using State = EmulatedPrinter::State;
  if (code.compare(0, 3, "M32") == 0) {
    const std::size_t quote = code.find('"');
    if (printer.state() != State::Idle)
      return "Error: M32: Cannot set file to print, because a file is already being printed\n";
    if (!printer.print(fileOnCard(code.substr(quote + 1, code.rfind('"') - quote - 1))))
      return "Error: M32: GCode file not found\n";
    return "File selected for printing\n";
  }
  if (code == "M0") {
    if (printer.state() == State::Printing)
      return "Error: M0: Pause the print before attempting to cancel it\n";
    printer.cancel();
  }
  if (code == "M25") {
    if (printer.state() == State::Idle)
      return "Error: M25: Cannot pause print, because no file is being printed!\n";
    printer.pause();
  }
  if (code == "M24") printer.resume();
  const bool is_change =
      code.compare(0, 3, "M22") == 0 || code.compare(0, 5, "M290 ") == 0 || code.compare(0, 5, "M486 ") == 0;
  if (is_change) printer.change(code);
  if (code == "M140 S-273.15") printer.bed_target_c = 0.0;
  if (code == "M568 P0 A0") printer.nozzle_target_c = 0.0;
  return {};
}

std::string complaintOf(const std::string& command) {
  return "Warning: " + command + ": Command is not supported";
}

json heaterOf(double current_c, double target_c) {
  return {{"current", current_c},
          {"active", target_c},
          {"standby", 0.0},
          {"state", target_c > 0.0 ? "active" : "off"}};
}

const char* statusOf(const EmulatedPrinter& printer) {
  if (printer.is_halted) return "halted";
  if (printer.state() == EmulatedPrinter::State::Printing) return "processing";
  return printer.state() == EmulatedPrinter::State::Paused ? "paused" : "idle";
}

/// A Duet that runs its firmware alone.
class EmulatedDuet final : public EmulatedPrintServer {
 public:
  HttpResponse answer(const HttpRequest& request, std::string_view body) override;
  void forgetSessions() override { session_key_ = 0; }

 private:
  HttpResponse connect(const std::string& given);
  HttpResponse answerRequest(const HttpRequest& request, const std::string& name, std::string_view body);
  HttpResponse upload(const HttpRequest& request, std::string_view body);
  HttpResponse reply();
  static HttpResponse error(int code) { return {200, json{{"err", code}}.dump()}; }

  std::uint32_t session_key_ = 0;
  std::size_t complaints_told_ = 0;
};

HttpResponse EmulatedDuet::answer(const HttpRequest& request, std::string_view body) {
  const std::string path = request.target.substr(0, request.target.find('?'));
  if (path.compare(0, 4, "/rr_") != 0) return {404, "<html>page not found</html>"};
  const std::string name = path.substr(4);
  if (name == "connect") return connect(queryValue(request.target, "password"));
  if (session_key_ == 0 || headerValue(request, "X-Session-Key") != std::to_string(session_key_))
    return {401, "<html>Not authorized</html>"};
  return answerRequest(request, name, body);
}

HttpResponse EmulatedDuet::connect(const std::string& given) {
  if (!password.empty() && given != password) return error(1);
  session_key_ = session_key_ * 7U + 4711U;
  return {200,
          json{{"err", 0}, {"sessionTimeout", 8000}, {"boardType", "duet3mini"}, {"sessionKey", session_key_}}
              .dump()};
}

HttpResponse EmulatedDuet::answerRequest(const HttpRequest& request, const std::string& name,
                                         std::string_view body) {
  const std::string file = fileOnCard(queryValue(request.target, "name"));
  if (name == "model") {
    const std::string key = queryValue(request.target, "key");
    return {
        200,
        json{{"key", key}, {"flags", "v"}, {"result", objectModelOf(printer, DuetHost::Board)[key]}}.dump()};
  }
  if (name == "reply") return reply();
  if (name == "upload") return request.method == "POST" ? upload(request, body) : error(1);
  if (name == "delete") return error(printer.files.erase(file) == 1 ? 0 : 1);
  if (name == "disconnect") {
    session_key_ = 0;
    return error(0);
  }
  if (name == "fileinfo") {
    const auto found = printer.files.find(file);
    if (found == printer.files.end()) return error(1);
    return {200, json{{"err", 0}, {"size", found->second.size()}}.dump()};
  }
  if (name != "gcode") return {500, "<html>Unknown request</html>"};
  runCodes(printer, queryValue(request.target, "gcode"));
  return {200, R"({"buff":240})"};
}

HttpResponse EmulatedDuet::upload(const HttpRequest& request, std::string_view body) {
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  const std::string expected = queryValue(request.target, "crc32");
  if (std::strtoul(expected.c_str(), nullptr, 16) != crc.checksum()) return error(1);
  printer.files[fileOnCard(queryValue(request.target, "name"))] = std::string(body);
  return error(0);
}

HttpResponse EmulatedDuet::reply() {
  std::string text;
  for (; complaints_told_ < printer.unknown.size(); ++complaints_told_)
    text += complaintOf(printer.unknown[complaints_told_]) + "\n";
  if (printer.outcome() == EmulatedPrinter::Outcome::Complete)
    text += "Finished printing file 0:/gcodes/" + printer.file() + ", print time was 0h 0m\n";
  return {200, text};
}

/// A Duet behind a single-board computer.
class EmulatedDuetWithComputer final : public EmulatedPrintServer {
 public:
  HttpResponse answer(const HttpRequest& request, std::string_view body) override;
  void forgetSessions() override { session_key_.clear(); }

 private:
  HttpResponse answerFile(const HttpRequest& request, const std::string& path, std::string_view body);

  std::string session_key_;
  int sessions_ = 0;
};

HttpResponse EmulatedDuetWithComputer::answer(const HttpRequest& request, std::string_view body) {
  const std::string path = request.target.substr(0, request.target.find('?'));
  if (path == "/machine/connect") {
    if (!password.empty() && queryValue(request.target, "password") != password) return {403, ""};
    session_key_ = "key" + std::to_string(++sessions_);
    return {200, json{{"sessionKey", session_key_}}.dump()};
  }
  if (path.compare(0, 9, "/machine/") != 0) return {200, "<!DOCTYPE html><html>Duet Web Control</html>"};
  if (session_key_.empty() || headerValue(request, "X-Session-Key") != session_key_) return {401, ""};
  if (path == "/machine/model") return {200, objectModelOf(printer, DuetHost::Computer).dump()};
  if (path == "/machine/code" && request.method == "POST") return {200, runCodes(printer, std::string(body))};
  if (path.compare(0, 14, "/machine/file/") == 0) return answerFile(request, path.substr(13), body);
  if (path == "/machine/disconnect") session_key_.clear();
  return {204, ""};
}

HttpResponse EmulatedDuetWithComputer::answerFile(const HttpRequest& request, const std::string& path,
                                                  std::string_view body) {
  const std::string file = fileOnCard(decodedFromUrl(path));
  if (request.method == "PUT") {
    printer.files[file] = std::string(body);
    return {201, ""};
  }
  const auto found = printer.files.find(file);
  if (found == printer.files.end()) return {404, file};
  if (request.method == "GET") return {200, found->second};
  printer.files.erase(found);
  return {204, ""};
}

}  // namespace

std::string fileOnCard(const std::string& path) {
  const std::string folder = "/gcodes/";
  const std::size_t at = path.find(folder);
  return at == std::string::npos ? path : path.substr(at + folder.size());
}

std::string runCodes(EmulatedPrinter& printer, const std::string& codes) {
  if (printer.is_halted) return "Error: halted\n";
  std::istringstream lines(codes);
  std::string reply;
  for (std::string code; std::getline(lines, code);) reply += runCode(printer, code);
  return reply;
}

json objectModelOf(const EmulatedPrinter& printer, DuetHost host) {
  using Outcome = EmulatedPrinter::Outcome;
  json job = {{"file", json::object()}};
  if (printer.state() != EmulatedPrinter::State::Idle) {
    job["file"]["fileName"] = "0:/gcodes/" + printer.file();
    job["filePosition"] = printer.position();
    job["lastFileName"] = nullptr;
  } else if (!printer.file().empty()) {
    const bool is_complete = printer.outcome() == Outcome::Complete;
    job["lastFileName"] = "0:/gcodes/" + printer.file();
    job["lastDuration"] = is_complete ? static_cast<int>(std::lround(printer.printTime())) : 0;
  }
  if (host == DuetHost::Computer) {
    job["lastFileCancelled"] = printer.outcome() == Outcome::Stopped;
    job["lastFileAborted"] = printer.outcome() == Outcome::Failed;
    job["lastFileSimulated"] = false;
  }
  json messages = json::array();
  for (std::size_t i = 0; host == DuetHost::Computer && i < printer.unknown.size(); ++i)
    messages.push_back({{"type", 1},
                        {"time", std::to_string(i)},
                        {"content", printer.unknown[i] + ": Command is not supported"}});
  const json axes = {{{"letter", "X"}, {"userPosition", 1.0}},
                     {{"letter", "Y"}, {"userPosition", 2.0}},
                     {{"letter", "Z"}, {"userPosition", 3.0}}};
  return {{"state", {{"status", statusOf(printer)}}},
          {"messages", messages},
          {"job", job},
          {"heat",
           {{"bedHeaters", {0, -1}},
            {"chamberHeaters", {-1}},
            {"heaters", {heaterOf(23.5, printer.bed_target_c), heaterOf(24.5, printer.nozzle_target_c)}}}},
          {"move", {{"axes", axes}, {"extruders", {{{"position", 4.0}}}}}},
          {"tools", {{{"number", 0}, {"heaters", {1}}}}}};
}

std::unique_ptr<EmulatedPrintServer> makeEmulatedDuet() { return std::make_unique<EmulatedDuet>(); }
std::unique_ptr<EmulatedPrintServer> makeEmulatedDuetWithComputer() {
  return std::make_unique<EmulatedDuetWithComputer>();
}

}  // namespace lamina
