// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/cell_time.hpp"
#include "lamina/cell/clock_comparison.hpp"
#include "lamina/cell/host_datagram.hpp"

namespace lamina {

/// Another host of the cell.
struct PeerHost {
  std::string name;
  bool is_needed = false;  ///< no job runs without it: its loss is alarm 8001
};

struct HostWatchSettings {
  std::string host = "motion";  ///< this one
  double silence_s = 2.0;       ///< of another host, after which it is lost
  double warn_offset_s = 0.005;
  double hold_offset_s = 0.020;
  bool is_clock_needed = false;   ///< jobs measure with stamps of another host: 8004 instead of 8003
  double master_silence_s = 5.0;  ///< without a good answer, after which the master is lost
  double least_free_bytes = 2.0 * 1024 * 1024 * 1024;  ///< of the watched folder's disk
};

/// What is to be raised, or has gone, by the table of alarms.
struct HostAlarm {
  int id = 0;
  double value = 0.0;
  std::string message;
  bool is_gone = false;
};

struct PeerStatus {
  PeerHost host;
  double heard_at_s = 0.0;  ///< by the steady clock
  bool is_lost = false;
  bool was_heard = false;
  ClockComparison clocks;
};

struct NodeStatus {
  std::string name;
  int pid = 0;  ///< 0 before it was first seen
  bool answers = false;
  int restarts = 0;
};

/// Watches what one host of a cell can see: the other hosts and their clocks, steps of its own clock, the ROS
/// master, its disk, the nodes. Events come in with the time they came at, alarms come out; nothing is sent
/// or asked by itself.
///
/// Hosts and clocks are reported only where there is another host. A clock counts as off only by what the
/// round trip does not explain.
class HostWatch {
 public:
  HostWatch(HostWatchSettings settings, const std::vector<PeerHost>& peers, CellTime now);

  /// The next question to a host; what it takes on its way is not counted before `answered`.
  HostDatagram ask(const std::string& peer, CellTime now);
  /// A question came: a sign of life.
  void onQuestion(const std::string& peer, CellTime now);
  /// An answer came. One to a question that was not asked lately says nothing.
  void onAnswer(const std::string& peer, const HostDatagram& answer, CellTime now);

  /// @param defect  why the master is not as it should be; empty if it knows this node
  void onMaster(const std::string& defect, CellTime now);
  void onFreeSpace(double bytes) { free_bytes_ = bytes; }
  /// @param pid  of the node's process; nothing if it did not answer
  void onNode(const std::string& name, std::optional<int> pid);

  /// Lets time pass. The first call says of all conditions that are not there that they are gone.
  std::vector<HostAlarm> tick(CellTime now);

  /// All conditions as they are, those that are not there as gone: for whoever begins to listen.
  std::vector<HostAlarm> present() const;

  const std::vector<PeerStatus>& peers() const { return peers_; }
  const std::vector<NodeStatus>& nodes() const { return nodes_; }
  bool hasMaster() const { return !is_master_lost_; }
  const std::string& masterDefect() const { return master_defect_; }
  std::optional<double> freeBytes() const { return free_bytes_; }

 private:
  struct Condition {
    double value = 0.0;
    std::string message;
  };
  struct Question {
    std::uint32_t sequence = 0;
    double asked_s = 0.0;
  };
  using Conditions = std::map<int, Condition>;

  PeerStatus* peerOf(const std::string& name);
  void watchOwnClock(CellTime now);
  void judgePeers(Conditions& found, CellTime now);
  void judgeClock(Conditions& found, const PeerStatus& peer) const;
  Conditions conditions(CellTime now);

  HostWatchSettings settings_;
  std::vector<PeerStatus> peers_;
  std::vector<NodeStatus> nodes_;
  std::map<std::string, std::vector<Question>> questions_;
  std::uint32_t sequence_ = 0;
  double clock_distance_s_;  ///< of the two clocks of this host
  double stepped_by_s_ = 0.0;
  double stepped_at_s_ = -1e9;
  double master_good_at_s_;
  bool is_master_lost_ = false;
  std::string master_defect_;
  std::optional<double> free_bytes_;
  std::vector<HostAlarm> events_;
  std::optional<Conditions> reported_;
};

}  // namespace lamina
