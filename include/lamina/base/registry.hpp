// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {

/// Implementations of one interface by name: those of Lamina, and those that plug-ins add
/// (`docs/installation/plugins.md`). All calls may come from any thread. `find` returns a copy, which stays
/// valid whatever is added or removed.
template <class Entry>
class Registry {
 public:
  /// @param chosen_by  the setting that names an entry, for messages: "infill.strategy"
  Registry(std::string chosen_by, std::map<std::string, Entry> built_in)
      : chosen_by_(std::move(chosen_by)), entries_(std::move(built_in)) {}
  Registry(const Registry&) = delete;
  Registry& operator=(const Registry&) = delete;

  /// @throws InvalidConfig if the name is empty, or another entry has it
  void add(const std::string& name, Entry entry) {
    if (name.empty()) throw InvalidConfig("an entry for " + chosen_by_ + " has no name; expected one");
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!entries_.emplace(name, std::move(entry)).second)
      throw InvalidConfig("'" + name + "' is already an entry for " + chosen_by_ + "; expected another name");
  }

  /// Removes an entry; without effect if there is none of that name.
  void remove(const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    entries_.erase(name);
  }

  bool has(const std::string& name) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return entries_.count(name) > 0;
  }

  /// The entry of that name.
  /// @throws InvalidConfig if there is none, listing the names that there are
  Entry find(const std::string& name) const {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = entries_.find(name);
      if (found != entries_.end()) return found->second;
    }
    throw InvalidConfig(chosen_by_ + " is '" + name + "'; must be one of " + listed(names(), " | "));
  }

  /// All names, in alphabetical order.
  std::vector<std::string> names() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> names;
    names.reserve(entries_.size());
    for (const auto& entry : entries_) names.push_back(entry.first);
    return names;
  }

 private:
  std::string chosen_by_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

}  // namespace lamina
