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

/// Speaks with the other hosts over UDP, in a thread of its own: asks, answers, and passes on to the watch
/// what it hears. Datagrams of anybody else are dropped. Receipts are stamped by the kernel.
class PeerLink {
 public:
  /// @param mutex  of the watch
  /// @throws DeviceError if the address cannot be had
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
