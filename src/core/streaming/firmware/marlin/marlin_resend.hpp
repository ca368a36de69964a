// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/firmware/marlin/line_proof.hpp"
#include "streaming/firmware/marlin/sent_lines.hpp"

namespace lamina {

/// Lines sent to firmware that requests missing ones again, and its requests: which lines a request confirms,
/// for how long nothing may be sent after it, and whether it can be followed.
///
/// `MarlinJob::onResend` asks this class what to do and goes back to the line; `job/line_feed` keeps the
/// lines.
///
/// A probe is a line that the firmware must refuse: the refusal names the line for which it waits.
class MarlinResend {
 public:
  enum class Contradiction { None, First, Repeated };

  explicit MarlinResend(const StreamSettings& settings);

  /// States that the firmware waits for this line, and that no line is under way.
  void beginAt(std::uint64_t line);
  /// Forgets the lines sent; their answers are no longer waited for.
  void forget();

  bool empty() const { return sent_.empty(); }
  bool hasBlocking() const { return sent_.hasBlocking(); }
  /// Whether a line of `bytes` bytes may be sent.
  bool hasRoom(std::size_t bytes) const;
  void sent(const SentLine& line);
  /// Evaluates an ok.
  /// @param named  number in the ok, if that line was sent
  /// @return the line up to which all lines are done; nothing if it is not known
  std::optional<std::uint64_t> acknowledge(const std::optional<std::uint64_t>& named);
  /// States that the acknowledged line was not done before.
  void proven() { proof_.acknowledged(); }
  /// Allows for late answers to everything that was sent.
  void doubtAnswers() { proof_.doubt(settings_.window_lines + 2); }

  void probed() { ++unanswered_probes_; }
  bool hasUnansweredProbe() const { return unanswered_probes_ > 0; }

  /// Begins a wait for `answers` due answers, any of which may be lost; no wait if 0.
  void waitFor(int answers, double now) {
    waits_for_oks_ = false;
    wait_until_ = answers > 0 ? now + settings_.settle_s : 0.0;
  }
  /// Begins a wait for the oks to commands without number: `M110` counts once more when it is run, and would
  /// set back a counter that goes by lines already. The wait begins anew whenever the firmware says that it
  /// runs a command.
  void waitForOks(int answers, double now) {
    waits_for_oks_ = true;
    wait_until_ = answers > 0 ? now + waitForLostOk() : 0.0;
  }
  void waitNoLonger() { wait_until_ = 0.0; }
  /// Whether nothing may be sent.
  bool isWaiting() const { return wait_until_ > 0.0; }
  double waitsUntil() const { return wait_until_; }
  /// Begins a wait for the answers to probes: firmware that refuses a probe would discard the beginning of
  /// the next line.
  void waitForProbes(double now) { waitFor(unanswered_probes_, now); }
  /// Ends the wait for answers once its time is over or no answer is due any more.
  void settle(double now);

  /// Evaluates any reply.
  /// @return whether it is the ok that follows a request
  bool hear(const FirmwareReply& reply, double now);
  /// Counts a request for any line.
  /// @return whether it answers a probe
  bool takeRequest();
  /// Whether the previous request was for the same line.
  bool isRepeated(std::uint64_t wanted) const { return wanted == rewound_to_; }
  /// Compares a request with what the firmware must have accepted already.
  /// @param taken  the last line acknowledged
  Contradiction contradictionOf(std::uint64_t wanted, std::uint64_t taken);
  /// Counts a request as the refusal of a line that was sent after a lost one.
  /// @return whether it is such a refusal
  bool absorb(std::uint64_t wanted) { return isRepeated(wanted) && sent_.absorbRefusal(); }
  /// Counts a request for a line that cannot be sent.
  /// @return whether there were too many such requests in a row
  bool isTooOdd();
  /// Counts a request for a line that is sent again.
  /// @return why this is not possible, in words, if the line is refused again and again; empty otherwise
  std::string follow(std::uint64_t wanted);
  /// States that a request refuses a line. What was sent after this line is refused too, or discarded.
  void refuse(std::uint64_t wanted, double now);
  /// States that a request answers a probe: the firmware has read all that was sent before.
  void allRead(double now);

 private:
  double waitForLostOk() const { return std::max(settings_.settle_s, settings_.probe_after_s); }

  StreamSettings settings_;
  SentLines sent_;
  LineProof proof_;
  bool expects_ok_of_request_ = false;  ///< whether the firmware sends an ok after a request
  bool is_asking_again_ = false;  ///< whether a request that contradicts what is known is being verified
  /// Whether a line is sent despite a full window: its lines were discarded, and it would never empty.
  bool must_send_one_ = false;
  /// Time until which nothing is sent, as stale lines may be answered; 0 if none is stale.
  double wait_until_ = 0.0;
  bool waits_for_oks_ = false;  ///< whether that wait is one for oks to commands without number
  std::uint64_t rewound_to_ = 0;
  int unanswered_probes_ = 0;
  int refusals_in_a_row_ = 0;
  int odd_requests_ = 0;
};

}  // namespace lamina
