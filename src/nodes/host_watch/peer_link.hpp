// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <netinet/in.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "lamina/cell/host_watch.hpp"
#include "watch_settings.hpp"

namespace lamina {

/// Exchanges datagrams with the other hosts over UDP, in a thread of its own: asks, answers, and passes
/// answers on to the watch. Datagrams of other senders are dropped. The kernel stamps the times of arrival.
class PeerLink {
 public:
  /// @param mutex  of the watch
  /// @throws DeviceError if the address cannot be used
  PeerLink(const HostWatchNodeSettings& settings, HostWatch& watch, std::mutex& mutex);
  ~PeerLink();
  PeerLink(const PeerLink&) = delete;
  PeerLink& operator=(const PeerLink&) = delete;

 private:
  struct Peer {
    std::string name;
    sockaddr_in address{};
  };
  void run();
  void askAll();
  void receive();
  void hear(const Peer& peer, HostDatagram datagram, CellTime at);
  void send(const Peer& peer, const HostDatagram& datagram) const;

  HostWatch& watch_;
  std::mutex& mutex_;
  std::vector<Peer> peers_;
  double interval_s_;
  double shift_s_;
  int socket_ = -1;
  std::atomic<bool> is_ending_{false};
  std::thread thread_;
};

/// This instant, with the clock shifted for trials.
CellTime shiftedNow(double shift_s);

}  // namespace lamina
