// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/cell_time.hpp"
#include "lamina/cell/unit_machine.hpp"

namespace lamina {

/// Time [s] for which a lease of the mode Manual holds unless its holder uses it again.
constexpr double kManualLease = 10.0;
/// Greatest time [s] of a step by hand. A button that is held repeats its step. The machine therefore stops
/// by itself soon after a hand, a page or a link is gone.
constexpr double kLongestManualStep = 0.3;

/// A step by hand.
struct ManualStep {
  std::string frame;   ///< joints, nozzle, part, bed or base_link
  std::string axis;    ///< name of a joint; otherwise x, y, z along, or rx, ry, rz about the frame's axis
  double step = 0.0;   ///< signed [m, rad]
  double speed = 0.0;  ///< above 0 [m/s, rad/s]
};

/// The caller, and the number of the lease that they present; 0 if they have none.
struct ManualCaller {
  std::string source;  ///< "page: anna"
  std::uint64_t lease = 0;
};

/// What decides whether the machine may be moved by hand.
struct ManualConditions {
  int mode = kProduction;
  UnitState state = UnitState::Stopped;
  std::string zone_fault;             ///< why the zone is not known to be free; empty if it is
  bool is_emergency_stopped = false;  ///< whether the alarm of an emergency stop (1207) is there
  bool has_driver = false;            ///< whether a node that jogs has been heard of
  std::vector<std::string> joints;    ///< joints that this node moves
};

/// Moving a machine by hand in the mode Manual: by one holder of a lease at a time, in short steps, while the
/// unit is in Stopped or Idle. Deterministic: all times are given.
class ManualControl {
 public:
  /// Gives the lease to a caller, or renews the lease that the caller presents. Its number is `lease()`.
  CommandAnswer take(const ManualCaller& who, const ManualConditions& found, CellTime now);

  /// Renews the caller's lease and begins a step, which replaces the one under way.
  CommandAnswer jog(const ManualCaller& who, const ManualStep& step, const ManualConditions& found,
                    CellTime now);

  /// Ends the caller's lease, and the step under way with it.
  CommandAnswer release(const ManualCaller& who, CellTime now);

  /// Ends the step whose time is over, and a lease that has run out or that the conditions do not allow any
  /// longer. To be called at least ten times a second.
  /// @return why a lease was lost just now; empty if none was
  std::string follow(const ManualConditions& found, CellTime now);

  /// The step under way; nothing if the machine is to rest.
  const std::optional<ManualStep>& motion() const { return motion_; }
  /// Holder of the lease; empty if nobody has it.
  const std::string& holder() const { return holder_; }
  /// Number of that lease; 0 if nobody has it.
  std::uint64_t lease() const { return holder_.empty() ? 0 : number_; }
  /// Time until the lease runs out [s]; 0 if nobody has it.
  double left(double now_s) const;

 private:
  CommandAnswer againstHolder(const ManualCaller& who, double now_s) const;
  bool isHeldBy(const ManualCaller& who, double now_s) const;
  void end();

  std::string holder_;
  std::uint64_t number_ = 0;  ///< of the last lease, unique also over restarts
  double until_s_ = 0.0;
  std::optional<ManualStep> motion_;
  double motion_until_s_ = 0.0;
};

}  // namespace lamina
