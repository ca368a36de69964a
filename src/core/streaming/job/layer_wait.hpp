// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// The wait of a machine at rest for a layer whose lines are not known yet.
class LayerWait {
 public:
  /// Begins a wait for a layer. At time `by` the layer is decided even if its lines are not known.
  void begin(double by) { by_ = by; }
  /// States that it was checked whether the lines are known.
  void look(double now) {
    constexpr double kLookInterval = 0.01;  // s
    next_look_ = now + kLookInterval;
  }
  void end() { by_ = 0.0; }

  bool isUnderWay() const { return by_ > 0.0; }
  bool isOver(double now) const { return now >= by_; }
  double nextLook() const { return next_look_; }

 private:
  double by_ = 0.0;  ///< 0 if no layer is waited for
  double next_look_ = 0.0;
};

}  // namespace lamina
