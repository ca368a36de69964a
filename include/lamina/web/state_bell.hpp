// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <set>

namespace lamina {

/// Wakes threads that wait for a new state beside something else, each by a descriptor of its own (eventfd).
/// All functions may be called from any thread.
class StateBell {
 public:
  /// Hears a bell as long as it lives; of one thread. The bell must outlive it.
  class Ear {
   public:
    /// @throws Error if the system gives no descriptor
    explicit Ear(StateBell& bell);
    ~Ear();
    Ear(const Ear&) = delete;
    Ear& operator=(const Ear&) = delete;

    /// Readable once the bell was rung since the last `clear`.
    int descriptor() const { return descriptor_; }
    void clear();

   private:
    StateBell& bell_;
    int descriptor_;
  };

  /// Whether anybody hears it.
  bool isHeard() const;
  void ring();

 private:
  mutable std::mutex mutex_;
  std::set<int> descriptors_;  ///< of the ears, guarded by it
};

}  // namespace lamina
