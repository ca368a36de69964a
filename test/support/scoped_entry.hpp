// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>

#include "lamina/base/registry.hpp"

namespace lamina::test {

/// An entry in a registry for as long as this lives.
template <class Entry>
class ScopedEntry {
 public:
  ScopedEntry(Registry<Entry>& registry, std::string name, Entry entry)
      : registry_(registry), name_(std::move(name)) {
    registry_.add(name_, std::move(entry));
  }
  ~ScopedEntry() { registry_.remove(name_); }
  ScopedEntry(const ScopedEntry&) = delete;
  ScopedEntry& operator=(const ScopedEntry&) = delete;

 private:
  Registry<Entry>& registry_;
  std::string name_;
};

}  // namespace lamina::test
