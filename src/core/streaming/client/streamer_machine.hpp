// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lamina/streaming/client/streamer.hpp"
#include "lamina/streaming/firmware/firmware_protocol.hpp"
#include "streaming/client/line_feed.hpp"
#include "streaming/client/line_proof.hpp"
#include "streaming/client/sent_lines.hpp"
#include "streaming/client/undone_commands.hpp"

namespace lamina {

/// Waits for the firmware's answers: says when to ask again, ever more rarely, and how long it has been
/// quiet.
class AnswerTimer {
 public:
  /// @param first_retry_s  after which to ask for the first time
  explicit AnswerTimer(double first_retry_s) : first_retry_s_(first_retry_s), retry_s_(first_retry_s) {}

  /// An answer came, or something is waited for from now on.
  void restart(double now) {
    quiet_since_ = now;
    retry_s_ = first_retry_s_;
    retry_at_ = now + retry_s_;
  }

  /// The question was put again.
  void asked(double now) {
    constexpr double kLongestRetry = 30.0;
    retry_s_ = std::min(2.0 * retry_s_, std::max(kLongestRetry, first_retry_s_));
    retry_at_ = now + retry_s_;
  }

  double quietFor(double now) const { return now - quiet_since_; }
  double quietSince() const { return quiet_since_; }
  double retryAt() const { return retry_at_; }

 private:
  double first_retry_s_;
  double retry_s_;
  double quiet_since_ = 0.0;
  double retry_at_ = 0.0;
};

/// What the streamer does, behind its interface.
class Streamer::Machine {
 public:
  Machine(const StreamableProgram& program, const StreamSettings& settings, ReplyListener heard);

  void start(double now);
  void receive(std::string_view bytes, double now);
  void elapse(double now);
  void disconnect(const std::string& why, double now);
  void reconnect(double now);
  bool isOffline() const { return phase_ == Phase::Offline; }
  bool pause(double now);
  bool resume(double now);
  void abort(const Failure& why, double now);

  std::string takeOutput();
  double nextDeadline() const;
  const StreamStatus& status() const { return status_; }
  std::vector<PackmlState> takeStateChanges();

 private:
  /// What is being waited for.
  enum class Phase {
    Idle,         ///< nothing
    Identifying,  ///< who is there
    Numbering,    ///< the firmware to count lines from base_ on, and to report so
    Reporting,    ///< the ok to each of reports_
    Feeding,      ///< answers to the lines under way
    Probing,      ///< which line the firmware has
    Draining,     ///< the end of all motions, or of all heating
    Offline,      ///< the link to come back, for the safe stop
  };

  void enter(PackmlState state);
  void beginPhase(Phase phase, double now);
  bool isWaiting() const;
  double silenceLimit() const;

  void onReply(const MarlinReply& reply, double now);
  void onOk(const MarlinReply& reply, double now);
  void onResend(const MarlinReply& reply, double now);
  void onRefusal(std::uint64_t wanted, double now);
  void onStart(double now);
  void onFatal(const MarlinReply& reply, double now);
  void onPause(const MarlinReply& reply, double now);
  void onResume(double now) {
    if (is_paused_by_machine_) resume(now);
  }
  void onNotDone(const MarlinReply& reply);
  void onIdentity(const MarlinReply& reply, double now);

  /// What is sent while the firmware still refuses a probe would lose its head.
  void awaitProbes(double now) { settle_until_ = unanswered_probes_ > 0 ? now + settings_.settle_s : 0.0; }
  void identify(double now) {
    beginPhase(Phase::Identifying, now);
    retry(now);
  }
  bool isRefuted(std::uint64_t wanted, double now);
  void prepareSafeStop(double now);
  void beginNumbering(std::uint64_t base, double now);
  void nextReport(double now);
  void proceed(double now);
  void pump(double now);
  bool hasRoom(std::size_t bytes) const;
  void probe(double now);
  void onProbeAnswer(std::uint64_t wanted, double now);
  void onAllTaken(double now);
  void askForRest();
  bool isSafe(const MarlinTemperatures& temperatures) const;
  bool goTo(std::uint64_t line, double now);
  void retry(double now);
  void timeOut(double now);
  std::string urgentStop() const;
  std::vector<std::string> safeStop() const;
  void settle(double now);
  bool isSettling() const { return settle_until_ > 0.0; }

  bool isStopping() const { return status_.state == PackmlState::Aborting; }
  void acknowledgedUpTo(std::uint64_t line);
  std::string whereItStands() const;
  void finishAborted(const std::string& remark);

  StreamSettings settings_;
  std::shared_ptr<const FirmwareProtocol> firmware_;
  ReplyListener heard_;
  StreamStatus status_;
  LineFeed feed_;
  SentLines sent_;
  AnswerTimer timer_;
  Phase phase_ = Phase::Idle;
  std::uint64_t base_ = 0;            ///< number after which lines count, while Numbering
  std::vector<std::string> reports_;  ///< still to be asked for, the last one first
  int report_attempts_ = 0;
  bool has_answered_ = false;
  bool has_begun_ = false;  ///< a line of the program may have been sent
  bool is_paused_by_machine_ = false;
  UndoneCommands undone_;
  LineProof proof_;
  bool is_asking_again_ = false;       ///< a request that contradicts what is known is being verified
  bool expects_ok_of_resend_ = false;  ///< firmware says ok after a request to resend
  double settle_until_ = 0.0;          ///< nothing is sent while stale lines may be answered; 0 if none is
  bool must_send_one_ = false;  ///< whatever the window, or a full one of discarded lines would wait for ever
  std::uint64_t rewound_to_ = 0;
  int unanswered_probes_ = 0;
  int refusals_in_a_row_ = 0;
  int odd_requests_ = 0;
  double safe_stop_by_ = 0.0;
  double safe_stop_latest_ = 0.0;  ///< however long the machine says that it is busy
  std::string received_;
  std::string output_;
  std::vector<PackmlState> entered_;
};

}  // namespace lamina
