// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/line_proof.hpp"

#include <algorithm>
#include <string_view>

namespace lamina {
namespace {

/// Whether a machine says so by itself: that it has nothing to do, or what its host is to show.
bool isUnasked(std::string_view text) { return text == "wait" || text.substr(0, 2) == "//"; }

bool isStrange(const FirmwareReply& reply) {
  switch (reply.kind) {
    case ReplyKind::LineError:
    case ReplyKind::NotDone:
    case ReplyKind::Unreadable:
      return true;
    case ReplyKind::Resend:
      return !reply.line;
    case ReplyKind::Information:
      return !reply.text.empty() && !reply.temperatures && !reply.position && reply.firmware_name.empty() &&
             reply.text.compare(0, 5, "echo:") != 0 && reply.text.compare(0, 4, "Cap:") != 0 &&
             !isUnasked(reply.text);
    default:
      return false;
  }
}

}  // namespace

void LineProof::asked(std::uint64_t line) { proven_ = std::max(proven_, line); }

void LineProof::acknowledged() {
  constexpr int kSure = 32;  // more oks than can be late
  if (++clean_oks_ >= kSure) stray_oks_ = 0;
}

void LineProof::doubt(int stray_oks) {
  stray_oks_ += stray_oks;
  clean_oks_ = 0;
}

void LineProof::hear(const FirmwareReply& reply) {
  if (isStrange(reply)) doubt(1);
}

bool LineProof::contradicts(std::uint64_t wanted, std::uint64_t taken) const {
  if (wanted < proven_) return true;
  return wanted <= taken && taken - wanted + 1 > static_cast<std::uint64_t>(stray_oks_);
}

}  // namespace lamina
