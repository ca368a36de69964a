// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/rung_store.hpp"

#include <boost/container_hash/hash.hpp>
#include <limits>
#include <utility>

namespace lamina {

KeptRung::KeptRung(const Rung& rung)
    : kind(rung.kind), samples(rung.samples), rows(rung.rows), branches(rung.branches), joints(rung.joints) {
  for (std::size_t slot = 0; slot < rung.penalty.size(); ++slot)
    if (rung.penalty[slot] < std::numeric_limits<double>::infinity())
      slots.push_back(static_cast<std::uint16_t>(slot));
  slots.shrink_to_fit();
  numbers.reserve(slots.size() * static_cast<std::size_t>(joints + 1));
  for (const std::uint16_t slot : slots) {
    numbers.push_back(rung.penalty[slot]);
    numbers.insert(numbers.end(), rung.at(slot), rung.at(slot) + joints);
  }
}

Rung KeptRung::rung() const {
  Rung rung;
  rung.kind = kind;
  rung.samples = samples;
  rung.rows = rows;
  rung.branches = branches;
  rung.joints = joints;
  const auto per_node = static_cast<std::size_t>(joints);
  const std::size_t nodes = rung.slot(samples, 0);
  rung.values.resize(nodes * per_node);
  rung.penalty.assign(nodes, std::numeric_limits<double>::infinity());
  const double* next = numbers.data();
  for (const std::uint16_t slot : slots) {
    rung.penalty[slot] = *next++;
    std::copy_n(next, per_node, rung.values.begin() + static_cast<std::ptrdiff_t>(slot * per_node));
    next += per_node;
  }
  return rung;
}

std::size_t KeptRung::bytes() const {
  return sizeof(KeptRung) + slots.size() * sizeof(std::uint16_t) + numbers.size() * sizeof(double);
}

std::size_t RungStore::Hash::operator()(const Key& key) const {
  return boost::hash_range(key.begin(), key.end());
}

RungStore::Key RungStore::keyOf(const Station& station) {
  const Point3& at = station.position;
  const auto& turn = station.orientation.coeffs();
  const auto& external = station.external;
  return {at.x(),  at.y(),      at.z(),      turn[0],     turn[1],           turn[2],
          turn[3], external[0], external[1], external[2], station.redundancy};
}

std::optional<Rung> RungStore::find(const Station& station) const {
  if (kept_.empty()) return std::nullopt;
  const auto found = kept_.find(keyOf(station));
  if (found == kept_.end()) return std::nullopt;
  return found->second.rung();
}

void RungStore::add(const Station& station, KeptRung rung) {
  if (rung.bytes() > room_) {
    room_ = 0;
    return;
  }
  const std::size_t bytes = rung.bytes();
  if (kept_.emplace(keyOf(station), std::move(rung)).second) room_ -= bytes;
}

}  // namespace lamina
