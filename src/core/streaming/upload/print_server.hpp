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

/// A step in the dialogue with a print server.
enum class UploadStep : std::uint8_t {
  Connect,  ///< identification, and a session if the server has sessions
  Report,   ///< state of machine and print
  Upload,
  Verify,  ///< comparison of the server's file with the one sent
  Start,
  Pause,
  Resume,
  Cancel,
  HeatersOff,     ///< switches off heaters and all other outputs that the program switches on
  Change,         ///< sends the command of the last `give`
  EmergencyStop,  ///< if the server has one that does not wait for other commands
  Remove,         ///< removes the file
  Disconnect,     ///< the end of the session
};

/// The meaning of a response.
struct ServerAnswer {
  enum class Kind : std::uint8_t {
    Done,
    More,       ///< the step has another request
    Later,      ///< the server cannot answer now; the step may have been done
    NotTaken,   ///< the step is not done, and may be repeated
    LoggedOut,  ///< the session is over: connect again
    NotMine,    ///< the server is of another kind
    Refused,
  };
  Kind kind = Kind::Done;
  Failure failure;  ///< of Later, NotTaken and Refused
};

using AnswerKind = ServerAnswer::Kind;

/// A program to upload, and the name of its file.
struct UploadOrder {
  ProgramBody body;
  std::string file;        ///< below the server's folder of programs: "lamina/part-0a1b2c3d.gcode"
  std::string credential;  ///< password or key; empty for none
  /// Longest time without a byte in either direction, and for storing the file.
  double upload_timeout_s = 60.0;
  double command_timeout_s = 10.0;
  JobStart start = JobStart::New;
  /// Beginning of the names of files that earlier sessions uploaded for this program.
  std::string earlier_files = {};
};

/// The protocol of a kind of print server: a state machine without time that issues requests and evaluates
/// responses. One request is made at a time.
class PrintServer {
 public:
  explicit PrintServer(std::shared_ptr<const UploadOrder> order)
      : printed_file(order->file), order_(std::move(order)) {}
  virtual ~PrintServer() = default;
  PrintServer(const PrintServer&) = delete;
  PrintServer& operator=(const PrintServer&) = delete;

  /// Name of the firmware behind the server, as in `stream.firmware`.
  virtual const char* firmware() const = 0;
  /// The next request of a step; nothing if the step needs no further one.
  virtual std::optional<HttpRequest> request(UploadStep step) = 0;
  /// Evaluates the response to the last request.
  virtual ServerAnswer read(UploadStep step, const HttpResponse& response) = 0;

  /// The command for a change of the running print.
  virtual ChangeCommand changed(const LiveChange& change) const = 0;
  /// Sets the command for the next step `Change`.
  void give(std::string command) { given_command = std::move(command); }
  /// How a person stops the machine at once, if it might not react to a stop; empty if it always reacts.
  virtual std::string emergencyStop() const { return {}; }

  /// Name of the file being printed: that of the order, unless another one is followed.
  const std::string& printedFile() const { return printed_file; }
  void follow(std::string file) { printed_file = std::move(file); }

  /// Complaints of the machine since the last call, in its own words: unknown commands and errors of any
  /// cause.
  std::vector<std::string> takeComplaints() { return std::exchange(complaints, {}); }

  const std::string& name() const { return server_name; }  ///< name that the server states, once connected
  const MachineReport& report() const { return last_report; }
  /// Whether the last report is on the print of the order.
  bool isOurs() const { return last_report.file == printed_file; }

 protected:
  const UploadOrder& order() const { return *order_; }
  /// Commands that switch off outputs which the program may have left on, except heaters and the part's fan.
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
/// @throws InvalidConfig if there is none for that firmware
std::vector<std::unique_ptr<PrintServer>> printServers(const std::string& firmware,
                                                       const std::shared_ptr<const UploadOrder>& order);

}  // namespace lamina
