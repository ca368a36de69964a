// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/job/job_record.hpp"
#include "streaming/job/layer_pause.hpp"
#include "streaming/upload/print_account.hpp"
#include "streaming/upload/print_server.hpp"
#include "streaming/upload/upload_stop.hpp"

namespace lamina {

/// The upload of a program over HTTP to a printer that prints it by itself: a state machine without input,
/// output or clock of its own. It issues requests, one at a time, and processes responses, failures, times
/// and commands.
///
/// It identifies the server, waits until the machine is ready and idle, uploads the file, verifies it and
/// starts the print. Then it polls the state of the print until the machine reports that this print is
/// complete. `lines_acknowledged` counts the lines that the machine has read.
///
/// The start is requested once. If it is not known whether the request arrived, the state of the print is
/// polled; the request is not repeated.
class UploadJob {
 public:
  /// @throws InvalidConfig if there is no print server for the firmware that `stream.firmware` names
  UploadJob(const StreamSettings& settings, std::shared_ptr<const UploadOrder> order);

  void start(double now);
  /// The next request; nothing while one is being made, or before `nextDeadline`.
  std::optional<HttpRequest> takeRequest(double now);
  /// States how many bytes of the program the current request has sent.
  void sent(std::uint64_t bytes);
  /// Evaluates the response to the current request. A response that arrives after a break must not be passed.
  void receive(const HttpResponse& response, double now);
  void fail(const HttpFailure& failure, double now);
  /// Whether the current request is to be broken off; true once.
  bool takeBreak() { return std::exchange(is_to_break_, false); }
  void elapse(double now);
  /// Time at which to call `elapse`, and then `takeRequest`; infinite if only a response is awaited.
  double nextDeadline() const;

  /// Pauses the print.
  /// @return false if the job is not in Execute
  bool pause(double now);
  /// Resumes the print.
  /// @return false if the job is not in Holding or Held
  bool resume(double now);
  /// Changes a setting of the running print. The machine's answer is in the status's message.
  /// @return why it is refused, in words; empty if it is taken
  std::string change(const LiveChange& change, double now);
  /// Ends the print, if it may have been started. Without effect once the job is over or being aborted.
  void abort(const Failure& why, double now);

  const StreamStatus& status() const { return record_.status; }
  std::vector<PackmlState> takeStateChanges() { return record_.takeStateChanges(); }
  /// Whether the request to start the print may have been sent, in this session or an earlier one.
  bool mayBeStarted() const { return may_be_started_; }
  /// Name of the firmware behind the server that answers, as in `stream.firmware`.
  const char* firmware() const { return server().firmware(); }
  /// Name of the printed file, below the server's folder of programs.
  const std::string& printedFile() const { return server().printedFile(); }

 private:
  enum class Phase : std::uint8_t {
    Connect,
    Check,
    Upload,
    Verify,
    Start,
    Follow,
    Finish,
    Stop,
    Remove,
    Leave,
    Over
  };

  /// Whether a request without an answer may have arrived.
  enum class Arrival : std::uint8_t {
    Never,     ///< nothing of it arrived
    NotTaken,  ///< the server has reported that it was not done
    Possible,  ///< it may have been done
  };

  UploadStep nextStep() const;
  bool isChangeNext() const;
  PrintServer& server() const { return *servers_.front(); }
  void beforeAsking(UploadStep step, double now);
  void onDone(UploadStep step, double now);
  void onRemoved();
  void onTrouble(UploadStep step, const Failure& why, Arrival arrival, double now);
  void onTroubleInPrint(UploadStep step, const Failure& why, Arrival arrival, double now);
  void onTroubleInStop(UploadStep step, const Failure& why, Arrival arrival);
  void onRefused(UploadStep step, const Failure& why, double now);
  void tryNextServer(double now);
  void onReport(double now);
  void check(double now);
  void awaitIdleness(double now);
  void awaitStart(double now);
  void follow(double now);
  void followHold(double now);
  void finish(double now);
  void complete();
  void stop(double now);
  void giveUpStop(double now);
  void onChangeFailed(const std::string& why);
  void pauseAtLayer(double now);
  void recognise(double now);
  void adopt(double now);
  void lose(double now);
  void close();

  StreamSettings settings_;
  std::shared_ptr<const UploadOrder> order_;
  std::vector<std::unique_ptr<PrintServer>> servers_;  ///< servers that may be there; the first one is asked
  JobRecord record_;
  PrintAccount account_;
  UploadStop stop_;

  Phase phase_ = Phase::Connect;
  std::optional<UploadStep> under_way_;
  std::optional<UploadStep> command_;  ///< step to be requested next, before a report
  bool is_to_break_ = false;
  bool is_logged_out_ = false;
  bool is_stored_ = false;  ///< whether the file is stored and equals the one sent
  bool may_be_stored_ = false;
  bool may_be_started_ = false;
  bool was_seen_ = false;      ///< whether the machine has reported that it prints it
  bool was_complete_ = false;  ///< whether the print was complete when following it began
  bool is_to_resume_ = false;  ///< whether to resume the print once it is paused
  std::string trouble_;        ///< the last problem
  int attempts_ = 0;           ///< number of requests of this step that brought no answer
  double next_at_ = 0.0;
  std::optional<double> busy_since_;
  double started_at_ = 0.0;  ///< time at which the start was requested
  double heard_at_ = 0.0;    ///< time of the last report
  double asked_at_ = 0.0;    ///< time at which a pause or its end was requested
  double completed_at_ = 0.0;
  std::deque<std::string> changes_;  ///< commands that are still to be sent, in order
  bool is_report_due_ = false;       ///< whether a report is needed before the next change
  LayerPause layer_pause_;
};

}  // namespace lamina
