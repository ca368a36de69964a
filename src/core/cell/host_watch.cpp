// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/host_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/decimals.hpp"
#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr int kHostLost = 8001;
constexpr int kMasterLost = 8002;
constexpr int kClockOff = 8003;
constexpr int kClockFarOff = 8004;
constexpr int kNodeRestarted = 8005;
constexpr int kDiskNearlyFull = 7002;
constexpr std::array<int, 5> kConditions = {kDiskNearlyFull, kHostLost, kMasterLost, kClockOff, kClockFarOff};

constexpr double kStep = 0.005;           // [s] of the clock, between two ticks
constexpr double kStepIsReported = 10.0;  // [s]: until the clocks were compared anew
constexpr std::size_t kQuestions = 64;    // an answer that comes later is none
constexpr double kMebibyte = 1048576.0;

std::string milliseconds(double duration_s) { return decimalText(duration_s * 1e3, 1) + " ms"; }

}  // namespace

HostWatch::HostWatch(HostWatchSettings settings, const std::vector<PeerHost>& peers, CellTime now)
    : settings_(std::move(settings)),
      clock_distance_s_(now.utc_s - now.steady_s),
      master_good_at_s_(now.steady_s) {
  for (const PeerHost& peer : peers) {
    PeerStatus status;
    status.host = peer;
    status.heard_at_s = now.steady_s;
    peers_.push_back(std::move(status));
  }
}

PeerStatus* HostWatch::peerOf(const std::string& name) {
  const auto found = std::find_if(peers_.begin(), peers_.end(),
                                  [&name](const PeerStatus& peer) { return peer.host.name == name; });
  return found == peers_.end() ? nullptr : &*found;
}

HostDatagram HostWatch::ask(const std::string& peer, CellTime now) {
  std::vector<Question>& asked = questions_[peer];
  if (asked.size() == kQuestions) asked.erase(asked.begin());
  asked.push_back({++sequence_, now.utc_s});
  return {HostDatagramKind::Question, sequence_, 0.0, 0.0};
}

void HostWatch::onQuestion(const std::string& peer, CellTime now) {
  PeerStatus* const status = peerOf(peer);
  if (status == nullptr) return;
  status->heard_at_s = now.steady_s;
  status->was_heard = true;
}

void HostWatch::onAnswer(const std::string& peer, const HostDatagram& answer, CellTime now) {
  PeerStatus* const status = peerOf(peer);
  std::vector<Question>& asked = questions_[peer];
  const auto question = std::find_if(asked.begin(), asked.end(), [&answer](const Question& each) {
    return each.sequence == answer.sequence;
  });
  if (status == nullptr || question == asked.end()) return;
  status->clocks.add({question->asked_s, answer.received_s, answer.answered_s, now.utc_s});
  asked.erase(question);
  onQuestion(peer, now);
}

void HostWatch::onMaster(const std::string& defect, CellTime now) {
  if (defect.empty()) master_good_at_s_ = now.steady_s;
  master_defect_ = defect;
}

void HostWatch::onNode(const std::string& name, std::optional<int> pid) {
  auto node = std::find_if(nodes_.begin(), nodes_.end(),
                           [&name](const NodeStatus& each) { return each.name == name; });
  if (node == nodes_.end()) node = nodes_.insert(node, NodeStatus{name, 0, false, 0});
  node->answers = pid.has_value();
  if (!pid || *pid == node->pid) return;
  if (std::exchange(node->pid, *pid) == 0) return;
  ++node->restarts;
  events_.push_back({kNodeRestarted, static_cast<double>(node->restarts),
                     name + " was started anew, for the " + std::to_string(node->restarts) +
                         ". time since this host is watched",
                     false});
}

/// Between two ticks both clocks of a host go on alike, but for a step.
void HostWatch::watchOwnClock(CellTime now) {
  const double distance_s = now.utc_s - now.steady_s;
  const double step_s = distance_s - std::exchange(clock_distance_s_, distance_s);
  if (std::abs(step_s) <= kStep) return;
  stepped_by_s_ = step_s;
  stepped_at_s_ = now.steady_s;
  questions_.clear();
  for (PeerStatus& peer : peers_) peer.clocks.forget();
}

void HostWatch::judgePeers(Conditions& found, CellTime now) {
  for (PeerStatus& peer : peers_) {
    const double silence_s = now.steady_s - peer.heard_at_s;
    const bool was_lost = std::exchange(peer.is_lost, silence_s > settings_.silence_s);
    if (peer.is_lost && !was_lost) peer.clocks.forget();
    if (!peer.is_lost) {
      judgeClock(found, peer);
    } else if (peer.host.is_needed) {
      Condition& lost = found[kHostLost];
      lost.value += 1.0;
      lost.message += (lost.message.empty() ? "" : "; ") + peer.host.name +
                      " has said nothing for more than " + nearestTenths(settings_.silence_s);
    }
  }
}

void HostWatch::judgeClock(Conditions& found, const PeerStatus& peer) const {
  const auto offset = peer.clocks.offset();
  if (!offset) return;
  const double surely_s = std::abs(offset->offset_s) - offset->uncertainty_s;
  const bool is_far = surely_s > settings_.hold_offset_s;
  const bool is_unsure = offset->uncertainty_s > settings_.hold_offset_s;
  if (!is_far && !is_unsure && surely_s <= settings_.warn_offset_s) return;
  Condition& off = found[is_far && settings_.is_clock_needed ? kClockFarOff : kClockOff];
  off.value = offset->offset_s * 1e3;
  off.message = "the clock of " + peer.host.name + " is ahead by " + milliseconds(offset->offset_s) +
                ", give or take " + milliseconds(offset->uncertainty_s) + "; expected at most " +
                milliseconds(is_far ? settings_.hold_offset_s : settings_.warn_offset_s);
}

HostWatch::Conditions HostWatch::conditions(CellTime now) {
  Conditions found;
  judgePeers(found, now);
  if (!peers_.empty() && now.steady_s - stepped_at_s_ < kStepIsReported)
    found[settings_.is_clock_needed ? kClockFarOff : kClockOff] = {
        stepped_by_s_ * 1e3, "the clock of " + settings_.host + " was set by " + milliseconds(stepped_by_s_) +
                                 " at once; expected it to be led slowly"};
  is_master_lost_ = now.steady_s - master_good_at_s_ > settings_.master_silence_s;
  if (is_master_lost_)
    found[kMasterLost] = {settings_.master_silence_s, master_defect_.empty()
                                                          ? "the ROS master has not answered for more than " +
                                                                nearestTenths(settings_.master_silence_s)
                                                          : master_defect_};
  if (free_bytes_ && *free_bytes_ < settings_.least_free_bytes)
    found[kDiskNearlyFull] = {
        *free_bytes_ / kMebibyte,
        "the disk of " + settings_.host + " has " + std::to_string(std::lround(*free_bytes_ / kMebibyte)) +
            " MiB left; expected at least " +
            std::to_string(std::lround(settings_.least_free_bytes / kMebibyte)) + " MiB"};
  return found;
}

std::vector<HostAlarm> HostWatch::present() const {
  std::vector<HostAlarm> alarms;
  if (!reported_) return alarms;
  for (const int id : kConditions) {
    const auto is = reported_->find(id);
    if (is == reported_->end())
      alarms.push_back({id, 0.0, "", true});
    else
      alarms.push_back({id, is->second.value, is->second.message, false});
  }
  return alarms;
}

std::vector<HostAlarm> HostWatch::tick(CellTime now) {
  watchOwnClock(now);
  Conditions found = conditions(now);
  std::vector<HostAlarm> alarms = std::exchange(events_, {});
  for (const int id : kConditions) {
    const auto is = found.find(id);
    const bool was_reported = reported_ && reported_->count(id) > 0;
    const bool is_more =
        was_reported && id == kHostLost && is != found.end() && is->second.value > reported_->at(id).value;
    if (is != found.end() && (!was_reported || is_more))
      alarms.push_back({id, is->second.value, is->second.message, false});
    else if (is == found.end() && (was_reported || !reported_))
      alarms.push_back({id, 0.0, "", true});
  }
  reported_ = std::move(found);
  return alarms;
}

}  // namespace lamina
