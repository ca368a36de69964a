// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "machine_alarms.hpp"

#include <array>

namespace lamina {
namespace {

constexpr int kStreamerLost = 2201;
constexpr int kStoppedInItsPlace = 2203;
constexpr int kNotStopped = 2204;
constexpr std::array<int, 2> kOfTheMachine = {kStreamerLost, kNotStopped};

}  // namespace

std::vector<HostAlarm> MachineAlarms::of(const GuardNews& news) {
  switch (news.kind) {
    case GuardNewsKind::Lost:
      raised_[kStreamerLost] = news.message;
      return {{kStreamerLost, 0.0, news.message, false}};
    case GuardNewsKind::NotStopped:
      raised_[kNotStopped] = news.message;
      return {{kNotStopped, 0.0, news.message, false}};
    case GuardNewsKind::Back:
      raised_.clear();
      return present();
    case GuardNewsKind::Stopped: {
      raised_.clear();
      std::vector<HostAlarm> alarms = present();
      alarms.insert(alarms.begin(), {kStoppedInItsPlace, 0.0, news.message, false});
      return alarms;
    }
  }
  return {};
}

std::vector<HostAlarm> MachineAlarms::present() const {
  std::vector<HostAlarm> alarms;
  for (const int id : kOfTheMachine) {
    const auto found = raised_.find(id);
    const bool is_gone = found == raised_.end();
    alarms.push_back({id, 0.0, is_gone ? "" : found->second, is_gone});
  }
  return alarms;
}

}  // namespace lamina
