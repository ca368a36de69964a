// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "streaming/emulator/print_server/emulated_print_server.hpp"

namespace lamina {
namespace {

using nlohmann::json;

/// What stands between two texts; empty if one of them is missing.
std::string between(std::string_view text, std::string_view before, std::string_view after) {
  const std::size_t start = text.find(before);
  if (start == std::string_view::npos) return {};
  const std::size_t first = start + before.size();
  const std::size_t end = text.find(after, first);
  if (end == std::string_view::npos) return {};
  return std::string(text.substr(first, end - first));
}

/// What Klipper gives of the objects and values that a query names: an object that it has not is empty, a
/// value null.
json askedOf(const json& status, const std::string& query) {
  json asked = json::object();
  std::istringstream objects(query);
  for (std::string object; std::getline(objects, object, '&');) {
    const std::size_t equals = object.find('=');
    const std::string name = decodedFromUrl(object.substr(0, equals));
    const json known = status.value(name, json::object());
    if (equals == std::string::npos) {
      asked[name] = known;
      continue;
    }
    asked[name] = json::object();
    std::istringstream values(object.substr(equals + 1));
    for (std::string value; std::getline(values, value, ',');)
      asked[name][value] = known.value(value, json());
  }
  return asked;
}

/// Klipper behind Moonraker. The checksum of an upload is not looked at: uploads that are damaged on the way
/// are found by what is read back.
class EmulatedMoonraker final : public EmulatedPrintServer {
 public:
  HttpResponse answer(const HttpRequest& request, std::string_view body) override;

 private:
  HttpResponse answerFiles(const HttpRequest& request, const std::string& path, std::string_view body);
  HttpResponse upload(const HttpRequest& request, std::string_view body);
  HttpResponse download(const std::string& file) const;
  HttpResponse start(const std::string& file);
  HttpResponse script(const std::string& text);
  json said() const;
  json status() const;
  static HttpResponse result(const json& value) { return {200, json{{"result", value}}.dump()}; }
  static HttpResponse error(int code, const std::string& message) {
    return {code, json{{"error", {{"code", code}, {"message", message}}}}.dump()};
  }
};

HttpResponse EmulatedMoonraker::answer(const HttpRequest& request, std::string_view body) {
  const std::string path = request.target.substr(0, request.target.find('?'));
  if (!password.empty() && headerValue(request, "X-Api-Key") != password) return error(401, "Unauthorized");
  if (path == "/server/info") {
    return result(
        {{"klippy_state", printer.is_halted ? "shutdown" : "ready"}, {"moonraker_version", "v0.9.3"}});
  }
  if (has_just_started && path.compare(0, 9, "/printer/") == 0) return error(404, "Not Found");
  if (path.compare(0, 14, "/server/files/") == 0) return answerFiles(request, path, body);
  if (path == "/printer/objects/query") {
    const std::string query = request.target.substr(std::min(path.size() + 1, request.target.size()));
    return result({{"eventtime", 1.0}, {"status", askedOf(status(), query)}});
  }
  if (path == "/server/gcode_store") return result({{"gcode_store", said()}});
  if (request.method != "POST") return error(404, "Not Found");
  if (printer.is_halted) return error(400, "Lost communication with MCU 'mcu'");
  if (path == "/printer/print/start") return start(queryValue(request.target, "filename"));
  if (path == "/printer/emergency_stop") printer.halt();
  if (path == "/printer/print/pause") printer.pause();
  if (path == "/printer/print/resume") printer.resume();
  if (path == "/printer/print/cancel") printer.cancel();
  if (path == "/printer/gcode/script") return script(queryValue(request.target, "script"));
  return result("ok");
}

HttpResponse EmulatedMoonraker::answerFiles(const HttpRequest& request, const std::string& path,
                                            std::string_view body) {
  if (path == "/server/files/upload") return upload(request, body);
  if (path == "/server/files/metadata") {
    const auto found = printer.files.find(queryValue(request.target, "filename"));
    if (found == printer.files.end()) return error(404, "Metadata not available");
    return result({{"size", found->second.size()}, {"filename", found->first}});
  }
  const std::string file = decodedFromUrl(path.substr(std::string_view("/server/files/gcodes/").size()));
  if (request.method != "DELETE") return download(file);
  if (printer.state() != EmulatedPrinter::State::Idle && printer.file() == file)
    return error(403, "File currently in use");
  if (printer.files.erase(file) == 0) return error(404, "File does not exist");
  return result("ok");
}

HttpResponse EmulatedMoonraker::upload(const HttpRequest& request, std::string_view body) {
  const std::string boundary = between(headerValue(request, "Content-Type") + ";", "boundary=", ";");
  const std::string folder = between(body, "name=\"path\"\r\n\r\n", "\r\n--");
  const std::string name = between(body, "filename=\"", "\"");
  const std::size_t part = body.find("filename=\"");
  if (boundary.empty() || name.empty()) return error(400, "Multipart filename omitted");
  const std::string file = folder.empty() ? name : folder + "/" + name;
  if (printer.state() != EmulatedPrinter::State::Idle && printer.file() == file)
    return error(403, "File is loaded, upload not permitted");
  printer.files[file] = between(body.substr(part), "\r\n\r\n", "\r\n--" + boundary + "--");
  return {201, json{{"item", {{"path", file}, {"root", "gcodes"}}}, {"action", "create_file"}}.dump()};
}

HttpResponse EmulatedMoonraker::download(const std::string& file) const {
  const auto found = printer.files.find(file);
  if (found == printer.files.end()) return error(404, "File does not exist");
  return {200, found->second};
}

HttpResponse EmulatedMoonraker::start(const std::string& file) {
  if (printer.state() == EmulatedPrinter::State::Printing) return error(400, "SD busy");
  if (!printer.print(file)) return error(400, "Unable to open file");
  return result("ok");
}

HttpResponse EmulatedMoonraker::script(const std::string& text) {
  if (text.find("TURN_OFF_HEATERS") != std::string::npos) {
    printer.nozzle_target_c = printer.bed_target_c = 0.0;
  } else if (text == "SDCARD_RESET_FILE") {
    printer.cancel();
  } else {
    printer.change(text);
  }
  return result("ok");
}

/// Of a longer list the end is asked for.
json EmulatedMoonraker::said() const {
  json messages = json::array();
  for (std::size_t i = 0; i < printer.unknown.size(); ++i)
    messages.push_back({{"message", "// Unknown command:\"" + printer.unknown[i] + "\""},
                        {"time", static_cast<double>(i)},
                        {"type", "response"}});
  return messages;
}

json EmulatedMoonraker::status() const {
  using Outcome = EmulatedPrinter::Outcome;
  std::string print = "standby";
  if (printer.outcome() == Outcome::Complete) print = "complete";
  if (printer.outcome() == Outcome::Stopped) print = "cancelled";
  if (printer.outcome() == Outcome::Failed) print = "error";
  if (printer.state() == EmulatedPrinter::State::Printing) print = "printing";
  if (printer.state() == EmulatedPrinter::State::Paused) print = "paused";
  const std::string message = print == "error" ? "Move out of range: 400.000\n0.000 0.000" : "";
  json heaters = json::array({"extruder"});
  if (printer.has_bed) heaters.push_back("heater_bed");
  json status = {{"webhooks",
                  {{"state", printer.is_halted ? "shutdown" : "ready"},
                   {"state_message",
                    printer.is_halted ? "Lost communication with MCU 'mcu'\nOnce the" : "Printer is ready"}}},
                 {"print_stats", {{"state", print}, {"filename", printer.file()}, {"message", message}}},
                 {"virtual_sdcard", {{"file_position", printer.position()}}},
                 {"toolhead", {{"stalls", printer.stalls}}},
                 {"idle_timeout", {{"state", printer.isMoving() ? "Printing" : "Ready"}}},
                 {"gcode_move", {{"gcode_position", {1.0, 2.0, 3.0, 4.0}}}},
                 {"heaters", {{"available_heaters", heaters}}},
                 {"extruder", {{"temperature", 24.5}, {"target", printer.nozzle_target_c}}}};
  if (printer.has_bed) status["heater_bed"] = {{"temperature", 23.5}, {"target", printer.bed_target_c}};
  if (printer.excludes_parts)
    status["exclude_object"] = {{"excluded_objects", json::array()}, {"current_object", nullptr}};
  return status;
}

}  // namespace

std::unique_ptr<EmulatedPrintServer> makeEmulatedMoonraker() { return std::make_unique<EmulatedMoonraker>(); }

}  // namespace lamina
