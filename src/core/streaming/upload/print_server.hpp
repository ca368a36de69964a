// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/streaming/job/job_start.hpp"
#include "streaming/job/change_commands.hpp"
#include "streaming/upload/http_exchange.hpp"
#include "streaming/upload/machine_report.hpp"
#include "streaming/upload/program_body.hpp"

namespace lamina {

/// What is asked of a print server.
enum class UploadStep : std::uint8_t {
  Connect,  ///< who it is; a session where it keeps such
  Report,   ///< how machine and print stand
  Upload,
  Verify,  ///< that it has the file as it was sent
  Start,
  Pause,
  Resume,
  Cancel,
  HeatersOff,     ///< and all else that the program switches on
  Change,         ///< what was given last (`give`)
  EmergencyStop,  ///< where there is one that does not wait behind other commands
  Remove,         ///< the file
  Disconnect,     ///< the end of the session
};

/// What a response means.
struct ServerAnswer {
  enum class Kind : std::uint8_t {
    Done,
    More,       ///< the step has another request
    Later,      ///< it cannot answer now, and may have done it
    NotTaken,   ///< it has not done it, and may be asked again
    LoggedOut,  ///< the session is over: connect again
    NotMine,    ///< another kind of server
    Refused,
  };
  Kind kind = Kind::Done;
  Failure failure;  ///< of Later, NotTaken and Refused
};

using AnswerKind = ServerAnswer::Kind;

/// What is uploaded, and under which name.
struct UploadOrder {
  ProgramBody body;
  std::string file;                ///< below the server's folder of programs: "lamina/part-0a1b2c3d.gcode"
  std::string credential;          ///< password or key; empty for none
  double upload_timeout_s = 60.0;  ///< without a byte either way, and for the server to store the file
  double command_timeout_s = 10.0;
  JobStart start = JobStart::New;
  std::string earlier_files = {};  ///< how the names of files begin that hold the same program
};

/// How a kind of print server is spoken to: requests out, responses in, no time. One request is under way at
/// a time.
class PrintServer {
 public:
  explicit PrintServer(std::shared_ptr<const UploadOrder> order)
      : printed_file(order->file), order_(std::move(order)) {}
  virtual ~PrintServer() = default;
  PrintServer(const PrintServer&) = delete;
  PrintServer& operator=(const PrintServer&) = delete;

  /// The firmware behind it, as `stream.firmware` names it.
  virtual const char* firmware() const = 0;
  /// The next request of a step; nothing if the step needs none.
  virtual std::optional<HttpRequest> request(UploadStep step) = 0;
  /// What the response to the last request means.
  virtual ServerAnswer read(UploadStep step, const HttpResponse& response) = 0;

  /// How a change is made there.
  virtual ChangeCommand changed(const LiveChange& change) const = 0;
  /// What is to be run at the next step `Change`.
  void give(std::string command) { given_command = std::move(command); }
  /// How a person stops the machine at once where it does not hear a stop; empty if it hears each.
  virtual std::string emergencyStop() const { return {}; }

  /// The file of the print: the one that is ordered, unless another is followed.
  const std::string& printedFile() const { return printed_file; }
  void follow(std::string file) { printed_file = std::move(file); }

  /// What the machine has complained of since the last call, in its own words: commands that it does not
  /// know, and errors, whoever caused them.
  std::vector<std::string> takeComplaints() { return std::exchange(complaints, {}); }

  const std::string& name() const { return server_name; }  ///< as it gives it, once connected
  const MachineReport& report() const { return last_report; }
  /// The last report is of the print that was ordered.
  bool isOurs() const { return last_report.file == printed_file; }

 protected:
  const UploadOrder& order() const { return *order_; }
  /// Lines that switch off what the program may have left on besides heaters and the fan that cools the part.
  std::string otherOutputsOff() const;

  std::string server_name;
  std::string printed_file;
  std::string given_command;
  std::vector<std::string> complaints;
  MachineReport last_report;

 private:
  std::shared_ptr<const UploadOrder> order_;
};

std::unique_ptr<PrintServer> makeMoonraker(std::shared_ptr<const UploadOrder> order);
std::unique_ptr<PrintServer> makeDuet(std::shared_ptr<const UploadOrder> order);
std::unique_ptr<PrintServer> makeDuetWithComputer(std::shared_ptr<const UploadOrder> order);

/// The kinds of servers that `stream.firmware` admits, in the order in which they are tried.
/// @throws InvalidConfig if none speaks for that firmware
std::vector<std::unique_ptr<PrintServer>> printServers(const std::string& firmware,
                                                       const std::shared_ptr<const UploadOrder>& order);

}  // namespace lamina
