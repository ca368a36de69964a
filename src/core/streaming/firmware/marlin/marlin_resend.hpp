// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_settings.hpp"
#include "streaming/firmware/marlin/line_proof.hpp"
#include "streaming/firmware/marlin/sent_lines.hpp"

namespace lamina {

/// The lines under way to firmware that requests missing ones again, and its requests: what they say of these
/// lines, for how long nothing may be sent after them, and which of them cannot be followed.
///
/// A probe is a line that the firmware must refuse, so that it names the line for which it waits.
class MarlinResend {
 public:
  enum class Contradiction { None, First, Repeated };

  explicit MarlinResend(const StreamSettings& settings);

  /// States that the firmware waits for this line, and that none is under way.
  void beginAt(std::uint64_t line);
  /// Forgets the lines under way: no answer to them is waited for.
  void forget();

  bool empty() const { return sent_.empty(); }
  bool hasBlocking() const { return sent_.hasBlocking(); }
  /// Whether a line may be sent of that many bytes.
  bool hasRoom(std::size_t bytes) const;
  void sent(const SentLine& line);
  /// Takes an ok.
  /// @param named  the line that it names, if that one was sent
  /// @return the line up to which all are done; nothing if it is not known
  std::optional<std::uint64_t> acknowledge(const std::optional<std::uint64_t>& named);
  /// States that such a line was not done before.
  void proven() { proof_.acknowledged(); }
  /// Allows for answers that come late, to all that was sent.
  void doubtAnswers() { proof_.doubt(settings_.window_lines + 2); }

  void probed() { ++unanswered_probes_; }
  bool hasUnansweredProbe() const { return unanswered_probes_ > 0; }

  /// Begins a wait, if that many answers are due, any of which may be lost.
  void waitFor(int answers, double now) { wait_until_ = answers > 0 ? now + settings_.settle_s : 0.0; }
  void waitNoLonger() { wait_until_ = 0.0; }
  /// Whether nothing may be sent.
  bool isWaiting() const { return wait_until_ > 0.0; }
  double waitsUntil() const { return wait_until_; }
  /// The firmware, refusing a probe, would discard the beginning of the next line.
  void waitForProbes(double now) { waitFor(unanswered_probes_, now); }
  /// Ends the wait for the answers to lines when it is over, or none is due any more.
  void settle(double now);

  /// Takes any reply.
  /// @return whether it is the ok that belongs to a request
  bool hear(const FirmwareReply& reply, double now);
  /// Takes a request, whatever it asks for.
  /// @return whether it answers a probe
  bool takeRequest();
  /// Whether that line was asked for last, too.
  bool isRepeated(std::uint64_t wanted) const { return wanted == rewound_to_; }
  /// The standing of a request against what the firmware must have.
  /// @param taken  the last line acknowledged
  Contradiction contradictionOf(std::uint64_t wanted, std::uint64_t taken);
  /// Takes a request as the refusal of a line that was sent after a lost one.
  /// @return whether it is one
  bool absorb(std::uint64_t wanted) { return isRepeated(wanted) && sent_.absorbRefusal(); }
  /// Takes a request for a line that cannot be sent.
  /// @return whether there were too many in a row
  bool isTooOdd();
  /// Takes a request for a line that is sent again.
  /// @return why this will not do, in words, if it is refused again and again; empty otherwise
  std::string follow(std::uint64_t wanted);
  /// States that a request comes from a refused line. What was sent behind it is refused too or discarded.
  void refuse(std::uint64_t wanted, double now);
  /// States that a request answers a probe: the firmware has read all that was sent before.
  void allRead(double now);

 private:
  StreamSettings settings_;
  SentLines sent_;
  LineProof proof_;
  bool expects_ok_of_request_ = false;  ///< firmware says ok after a request
  bool is_asking_again_ = false;        ///< a request that contradicts what is known is being verified
  bool must_send_one_ = false;  ///< despite a full window of discarded lines, which would wait for ever
  double wait_until_ = 0.0;     ///< nothing is sent while stale lines may be answered; 0 if none is
  std::uint64_t rewound_to_ = 0;
  int unanswered_probes_ = 0;
  int refusals_in_a_row_ = 0;
  int odd_requests_ = 0;
};

}  // namespace lamina
