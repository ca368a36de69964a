// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "streaming/firmware/marlin/line_enquiry.hpp"
#include "streaming/firmware/marlin/line_proof.hpp"
#include "streaming/firmware/marlin/sent_lines.hpp"
#include "streaming/job/answer_timer.hpp"
#include "streaming/job/job_record.hpp"
#include "streaming/job/layer_pause.hpp"
#include "streaming/job/line_feed.hpp"
#include "streaming/job/reply_lines.hpp"
#include "streaming/job/revised_lines.hpp"
#include "streaming/job/starvation_watch.hpp"
#include "streaming/job/undone_commands.hpp"
#include "streaming/job/used_outputs.hpp"

namespace lamina {

/// Streams to firmware that counts lines and requests missing ones again.
class MarlinJob final : public StreamJob {
 public:
  MarlinJob(StreamOrder order, std::shared_ptr<const MarlinFirmware> firmware);

  void start(double now) override;
  void receive(std::string_view bytes, double now) override;
  void elapse(double now) override;
  void disconnect(const std::string& why, double now) override;
  void reconnect(double now) override;
  bool isOffline() const override { return phase_ == Phase::Offline; }
  bool pause(double now) override;
  bool resume(double now) override;
  std::string change(const LiveChange& change, double now) override;
  bool ask(const std::string& command, double now) override;
  void abort(const Failure& why, double now) override;

  std::string takeOutput() override;
  double nextDeadline() const override;
  const StreamStatus& status() const override { return record_.status; }
  std::vector<PackmlState> takeStateChanges() override { return record_.takeStateChanges(); }

 private:
  /// What the job waits for.
  enum class Phase {
    Idle,         ///< nothing
    Enquiring,    ///< the last line of an unfinished job that the firmware has
    Identifying,  ///< the name of the firmware
    Numbering,    ///< the firmware to count lines from base_ on, and to report so
    Confirming,   ///< the answers due from before, so that none is taken for that of a line
    Reporting,    ///< the ok to each of reports_
    Feeding,      ///< answers to the lines under way
    Changing,     ///< the ok to the first of changes_
    Probing,      ///< the last line that the firmware has
    Draining,     ///< the end of all motions, or of all heating
    Offline,      ///< the link to come back, for the safe stop
  };

  void beginPhase(Phase phase, double now);
  bool isWaiting() const;
  double silenceLimit() const;

  void onReply(const FirmwareReply& reply, double now);
  void onOk(const FirmwareReply& reply, double now);
  void onResend(const FirmwareReply& reply, double now);
  void onRefusal(std::uint64_t wanted, double now);
  void onStart(double now);
  void onFatal(const FirmwareReply& reply, double now);
  void onPause(const FirmwareReply& reply, double now);
  void onResume(double now) {
    if (is_paused_by_machine_) resume(now);
  }
  void onNotDone(const FirmwareReply& reply);
  void onIdentity(const FirmwareReply& reply, double now);

  /// Nothing is sent for a while: the firmware, refusing a probe, would discard the beginning of the next
  /// line.
  void awaitProbes(double now) { settle_until_ = unanswered_probes_ > 0 ? now + settings_.settle_s : 0.0; }
  void identify(double now) {
    beginPhase(Phase::Identifying, now);
    retry(now);
  }
  bool isRefuted(std::uint64_t wanted, double now);
  void hearEnquiry(const FirmwareReply& reply, double now);
  void followEnquiry(double now);
  void goOnAfter(std::uint64_t number, double now);
  void prepareSafeStop(double now);
  void beginNumbering(std::uint64_t base, double now);
  void nextReport(double now);
  void proceed(double now);
  bool beginChange(double now);
  bool awaitLayer(double now);
  bool isAwaitingLayer() const {
    return layer_due_ > 0.0 && phase_ == Phase::Feeding && record_.status.state == PackmlState::Execute;
  }
  void pump(double now);
  void noteSent(const ProgramLine& line, double now);
  bool hasRoom(std::size_t bytes) const;
  void confirm(double now);
  void onReportDone(double now);
  void probe(double now);
  void onProbeAnswer(std::uint64_t wanted, double now);
  void onAllTaken(double now);
  void askForRest();
  bool isSafe(const ReportedTemperatures& temperatures) const;
  bool goTo(std::uint64_t line, double now);
  void retry(double now);
  void timeOut(double now);
  void settle(double now);
  bool isSettling() const { return settle_until_ > 0.0; }

  bool isStopping() const { return record_.isStopping(); }
  void acknowledgedUpTo(std::uint64_t line, const FirmwareReply& reply, double now);
  /// All motions have ended; the reports are being turned off.
  bool isAtRest() const {
    return phase_ == Phase::Reporting && record_.status.state == PackmlState::Completing;
  }
  void finishComplete();
  void finishAborted(const std::string& remark);

  StreamSettings settings_;
  std::shared_ptr<const MarlinFirmware> firmware_;
  ReplyListener heard_;
  JobRecord record_;
  StreamableProgram program_;
  const std::uint64_t line_base_;          ///< number of the line before the program's first
  std::unique_ptr<LineEnquiry> enquiry_;   ///< of a job that goes on
  std::shared_ptr<RevisedLines> revised_;  ///< null if the lines go as they are
  LineFeed feed_;
  SentLines sent_;
  AnswerTimer timer_;
  std::optional<std::string> firmware_name_;  ///< if the machine was asked before
  Phase phase_ = Phase::Idle;
  std::uint64_t base_ = 0;            ///< number after which lines count, while Numbering
  std::vector<std::string> reports_;  ///< still to be asked for, the last one first
  int report_attempts_ = 0;
  bool has_answered_ = false;
  bool has_begun_ = false;  ///< a line of the program may have been sent
  bool is_paused_by_machine_ = false;
  UndoneCommands undone_;
  UsedOutputs outputs_;
  std::deque<std::string> changes_;  ///< asked for by a person
  LayerPause layer_pause_;
  bool is_rest_asked_ = false;  ///< for the layer that is not known yet
  double layer_due_ = 0.0;      ///< when it is decided; 0 while none is waited for
  double next_look_ = 0.0;      ///< whether it is known
  StarvationWatch starvation_;
  LineProof proof_;
  bool is_asking_again_ = false;       ///< a request that contradicts what is known is being verified
  bool expects_ok_of_resend_ = false;  ///< firmware says ok after a request to resend
  double settle_until_ = 0.0;          ///< nothing is sent while stale lines may be answered; 0 if none is
  bool must_send_one_ = false;  ///< despite a full window of discarded lines, which would wait for ever
  std::uint64_t rewound_to_ = 0;
  int unanswered_probes_ = 0;
  int answers_due_ = 0;  ///< oks to what has no number and was sent before the first line
  int refusals_in_a_row_ = 0;
  int odd_requests_ = 0;
  double safe_stop_by_ = 0.0;
  double safe_stop_latest_ = 0.0;  ///< however long the machine says that it is busy
  ReplyLines replies_;
  std::string output_;
};

}  // namespace lamina
