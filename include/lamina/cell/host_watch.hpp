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
  bool is_needed = false;  ///< whether jobs need it: its loss is alarm 8001
};

/// Settings of the watch of one host.
struct HostWatchSettings {
  std::string host = "motion";    ///< name of this host
  double silence_s = 2.0;         ///< time without a message after which another host is lost
  double warn_offset_s = 0.005;   ///< greatest offset of a clock without an alarm
  double hold_offset_s = 0.020;   ///< greatest offset of a clock without alarm 8004
  bool is_clock_needed = false;   ///< jobs measure with time stamps of another host: 8004 instead of 8003
  double master_silence_s = 5.0;  ///< time without a good answer after which the ROS master is lost
  double least_free_bytes = 2.0 * 1024 * 1024 * 1024;  ///< least free space on the disk of the watched folder
};

/// An alarm of the table that is to be raised, or whose cause is gone.
struct HostAlarm {
  int id = 0;
  double value = 0.0;
  std::string message;
  bool is_gone = false;
};

/// The state of another host as far as this host knows it.
struct PeerStatus {
  PeerHost host;
  double heard_at_s = 0.0;  ///< time of its last message, by the steady clock
  bool is_lost = false;
  bool was_heard = false;
  ClockComparison clocks;
};

/// The state of a ROS node.
struct NodeStatus {
  std::string name;
  int pid = 0;  ///< process; 0 before it was first seen
  bool answers = false;
  int restarts = 0;
};

/// Watches what one host of a cell can observe: the other hosts and their clocks, steps of its own clock, the
/// ROS master, its disk, and the nodes. Events are passed in at the time of their arrival, and alarms are
/// returned; the class itself sends no messages.
///
/// Hosts and clocks are reported only if there is another host. Only the part of a clock's offset that the
/// round trip does not explain counts as a deviation. A round trip so long that the uncertainty exceeds
/// `hold_offset_s` is reported too. A step of this host's clock is reported for 10 s.
class HostWatch {
 public:
  HostWatch(HostWatchSettings settings, const std::vector<PeerHost>& peers, CellTime now);

  /// The next question to a host. To be called when it is sent: `now` is the time of the question.
  HostDatagram ask(const std::string& peer, CellTime now);
  /// States that a question of a host has arrived, a sign of life. Unknown hosts are ignored.
  void onQuestion(const std::string& peer, CellTime now);
  /// States that an answer of a host has arrived. An answer to a question that was not asked lately is
  /// ignored.
  void onAnswer(const std::string& peer, const HostDatagram& answer, CellTime now);

  /// States how the ROS master has answered.
  /// @param defect  what is wrong with it; empty if it knows this node
  void onMaster(const std::string& defect, CellTime now);
  /// States the free space on the watched disk.
  void onFreeSpace(double bytes) { free_bytes_ = bytes; }
  /// States whether a node has answered.
  /// @param pid  of the node's process; nothing if it did not answer
  void onNode(const std::string& name, std::optional<int> pid);

  /// The alarms that are new or gone since the last call; to be called regularly. The first call also returns
  /// every absent condition as gone.
  std::vector<HostAlarm> tick(CellTime now);

  /// All conditions at the last `tick`, the absent ones as gone, for a listener that has just connected.
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
  double clock_distance_s_;  ///< difference of the two clocks of this host
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
