// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "streaming/firmware/marlin/line_enquiry.hpp"
#include "streaming/firmware/marlin/marlin_resend.hpp"
#include "streaming/firmware/marlin/person_wait.hpp"
#include "streaming/firmware/marlin/report_requests.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"
#include "streaming/firmware/marlin/unnumbered_commands.hpp"
#include "streaming/job/answer_timer.hpp"
#include "streaming/job/job_record.hpp"
#include "streaming/job/layer_pause.hpp"
#include "streaming/job/layer_wait.hpp"
#include "streaming/job/line_account.hpp"
#include "streaming/job/line_feed.hpp"
#include "streaming/job/reply_lines.hpp"
#include "streaming/job/revised_lines.hpp"
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
    Confirming,   ///< the answers due from before, so that none is counted for a line
    Reporting,    ///< the ok to the first of reports_
    Feeding,      ///< answers to the lines under way
    Changing,     ///< the ok to the first of unnumbered_
    Probing,      ///< the last line that the firmware has
    Draining,     ///< the end of all motions, or of all heating
    Offline,      ///< the link to come back, for the safe stop
  };

  void beginPhase(Phase phase, double now);
  bool isWaiting() const;
  double silenceLimit() const;

  void onReply(const FirmwareReply& reply, double now);
  void onKind(const FirmwareReply& reply, double now);
  void onIdentity(const FirmwareReply& reply, double now);
  void onEnded(const FirmwareReply& reply, double now);
  /// Follows the machine's waits for a person. The job is held during a wait, and resumes afterwards.
  void followPerson(const FirmwareReply& reply, double now) {
    const PersonWait::News news = person_.hear(reply);
    if (news == PersonWait::News::None || isStopping()) return;
    if (news == PersonWait::News::Ended) {
      record_.status.wait.clear();
      if (is_paused_by_machine_) resume(now);
      return;
    }
    record_.status.message = record_.status.wait = person_.advice(reply.text);
    if (record_.status.state == PackmlState::Execute && pause(now)) is_paused_by_machine_ = true;
    // The lines under way are queued behind the line that waits.
    if (record_.status.state == PackmlState::Holding) record_.enter(PackmlState::Held);
  }
  /// Ends the machine's wait for a person. The answer follows the answers to the lines under way.
  void releaseFromWait() {
    record_.status.wait.clear();
    if (!person_.release()) return;
    for (const std::string& command : firmware_->interruption()) {
      output_ += command + "\n";
      resend_.sent({feed_.next() - 1, command.size() + 1, false, false, false});
    }
  }
  /// As `releaseFromWait`, for a wait of the last line: no other line is under way, and the job is no longer
  /// held.
  /// @return whether the machine waits
  bool releaseFromLastWait() {
    if (record_.status.state != PackmlState::Completing || record_.status.wait.empty()) return false;
    record_.status.wait.clear();
    if (!person_.release()) return true;
    for (const std::string& command : firmware_->interruption()) output_ += command + "\n";
    return true;
  }
  void onOk(const FirmwareReply& reply, double now);
  void acknowledgedUpTo(std::uint64_t line, const FirmwareReply& reply, double now);
  void onResend(const FirmwareReply& reply, double now);
  bool isRefuted(std::uint64_t wanted, double now);
  bool goTo(std::uint64_t line, double now);
  void probe();
  void onProbeAnswer(std::uint64_t wanted, double now);

  void identify(double now) {
    beginPhase(Phase::Identifying, now);
    retry(now);
  }
  void followEnquiry(double now);
  void goOnAfter(std::uint64_t number, double now);
  void beginNumbering(std::uint64_t base, double now);
  void confirm(double now);
  void nextReport(double now);
  void askReport();
  void onReportDone(double now);

  void proceed(double now);
  bool beginChange(double now);
  bool awaitLayer(double now);
  bool isAwaitingLayer() const {
    return layer_wait_.isUnderWay() && phase_ == Phase::Feeding &&
           record_.status.state == PackmlState::Execute;
  }
  void pump(double now);
  void noteSent(const ProgramLine& line, double now);
  void onAllTaken(double now);
  void askForRest();

  void retry(double now);
  void timeOut(double now);

  bool isStopping() const { return record_.isStopping(); }
  /// Whether a message of the machine may concern a line of the program.
  bool isAnsweringLines() const {
    return !isStopping() && (phase_ == Phase::Feeding || phase_ == Phase::Probing);
  }
  void fail(ErrorCode code, const std::string& what, double now) {
    abort({code, what + record_.whereItStands()}, now);
  }
  void failHalted(const FirmwareReply& reply, double now) {
    is_halted_ = true;
    fail(ErrorCode::Rejected, "the machine halted: \"" + reply.text + "\"", now);
  }
  void prepareSafeStop(double now);
  /// Whether the machine has ended the safe stop, by its answer to the question that follows the lines of the
  /// stop. What it reports unasked shows nothing: these lines may wait behind long motions. A tool that is
  /// still heated, for example since its T command was lost, is switched off by the number in the report.
  bool endsStop(const FirmwareReply& reply) {
    if (reply.kind != ReplyKind::Ok || !reply.temperatures) return false;
    if (isSafe(*reply.temperatures, settings_)) return true;
    for (const std::string& command : reportedToolsOff(reply.text)) output_ += command + "\n";
    return false;
  }
  /// Whether all motions have ended and the reports are being turned off.
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
  const std::uint64_t line_base_;          ///< number of the line before the program's first line
  std::unique_ptr<LineEnquiry> enquiry_;   ///< of a job that is resumed
  std::shared_ptr<RevisedLines> revised_;  ///< null if the lines are sent unchanged
  LineFeed feed_;
  LineAccount account_;
  MarlinResend resend_;
  AnswerTimer timer_;
  std::optional<std::string> firmware_name_;  ///< known if the machine was asked before
  Phase phase_ = Phase::Idle;
  std::uint64_t base_ = 0;  ///< number after which lines are counted; used while Numbering
  ReportRequests reports_;  ///< reports that are still to be requested
  int answers_due_ = 0;     ///< number of oks to commands without number that were sent before the first line
  bool has_answered_ = false;
  bool has_begun_ = false;  ///< whether a line of the program may have been sent
  bool is_halted_ = false;  ///< whether it has said so: it hears nothing until it is reset
  bool is_paused_by_machine_ = false;
  PersonWait person_;
  UsedOutputs outputs_;
  UnnumberedCommands unnumbered_;
  LayerPause layer_pause_;
  LayerWait layer_wait_;
  double safe_stop_by_ = 0.0;
  double safe_stop_latest_ = 0.0;  ///< latest time, however long the machine reports to be busy
  ReplyLines replies_;
  std::string output_;
};

}  // namespace lamina
