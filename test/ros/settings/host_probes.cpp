// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The watch of a host: other hosts, their clocks, the master.
#include "lamina/base/error.hpp"
#include "nodes/host_watch/watch_settings.hpp"
#include "ros/settings/node_probes.hpp"

namespace lamina::test {
namespace {

/// Alarms of a host and when they come; the other one's clock is ahead by so much, and it falls silent at 10
/// s with the master.
std::string watched(double ahead_s, const SettingTexts& set) {
  const double utc_s = 1.7e9;
  HostWatch watch(watchOf(settingsWith<HostWatchNodeSettings>(set)), {{"sensing", true}}, {0.0, utc_s});
  std::string text;
  for (int i = 0; i < 400; ++i) {
    const double now_s = 0.1 * i;
    HostDatagram question = watch.ask("sensing", {now_s, utc_s + now_s});
    if (now_s < 10.0) {
      question.kind = HostDatagramKind::Answer;
      question.received_s = question.answered_s = utc_s + now_s + ahead_s + 0.0005;
      watch.onAnswer("sensing", question, {now_s + 0.001, utc_s + now_s + 0.001});
      watch.onMaster("", {now_s, utc_s + now_s});
    }
    watch.onFreeSpace(3.0 * 1024 * 1024 * 1024);
    for (const HostAlarm& alarm : watch.tick({now_s + 0.002, utc_s + now_s + 0.002}))
      if (!alarm.is_gone) text += std::to_string(i) + ": " + std::to_string(alarm.id) + "\n";
  }
  return text + "watched";
}

/// The other hosts, and where they are spoken to.
std::string hostsNamed(const SettingTexts& set) {
  std::string text;
  try {
    for (const PeerAddress& peer : peersOf(settingsWith<HostWatchNodeSettings>(set)))
      text += peer.host.name + (peer.host.is_needed ? " needed " : " ") + peer.address + " " +
              std::to_string(peer.port) + "\n";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return text;
}

}  // namespace

std::vector<SettingProbe> hostProbes() {
  const auto near = [](const SettingTexts& set) { return watched(0.008, set); };
  const auto far = [](const SettingTexts& set) { return watched(0.050, set); };
  return {{"a host that falls silent",
           "",
           near,
           {{"hosts.silence_s=4"}, {"master.silence_s=10"}, {"clock.warn_s=0.01"}, {"disk.least_gib=5"}}},
          {"a host whose clock is off",
           "clock.is_needed=true",
           far,
           {{"clock.hold_s=0.1"}, {"clock.is_needed=false"}}},
          {"where the other hosts are",
           "hosts.peers={sensing: 192.0.2.1}",
           hostsNamed,
           {{"hosts.peers={sensing: 192.0.2.2}"}, {"hosts.port=11413"}, {"hosts.needed=sensing"}}}};
}

}  // namespace lamina::test
