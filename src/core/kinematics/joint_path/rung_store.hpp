// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "kinematics/joint_path/rung.hpp"
#include "kinematics/joint_path/stations.hpp"

namespace lamina {

/// A rung without room for nodes that do not exist.
struct KeptRung {
  SampleKind kind = SampleKind::Single;
  int samples = 0;
  int rows = 1;
  int branches = 0;
  int joints = 0;
  std::vector<std::uint16_t> slots;  ///< of the nodes that exist
  std::vector<double> numbers;       ///< penalty and joint values, node after node

  explicit KeptRung(const Rung& rung);

  /// The rung, bit for bit.
  Rung rung() const;
  std::size_t bytes() const;
};

/// Rungs of stations, kept from one plan of a toolpath to the next. When some motions are divided most
/// stations stay unchanged, and solving their rungs takes most of the time. Rungs are kept as long as there
/// is room.
class RungStore {
 public:
  /// @param most_bytes  room for all rungs together; 0 keeps nothing
  explicit RungStore(std::size_t most_bytes) : room_(most_bytes) {}

  bool isFull() const { return room_ == 0; }

  /// The rung of a station whose pose, external axes and redundancy are the same; nothing if none is kept.
  /// Calls may come from several threads, while nothing is added.
  std::optional<Rung> find(const Station& station) const;

  /// Keeps a rung if there is room. The first rung that does not fit marks the store as full.
  void add(const Station& station, KeptRung rung);

 private:
  using Key = std::array<double, 11>;
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  static Key keyOf(const Station& station);

  std::size_t room_;
  std::unordered_map<Key, KeptRung, Hash> kept_;
};

}  // namespace lamina
