// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// The machine's side of a raw pseudo-terminal. The other side is held open too, so that it outlives its
/// users.
class PseudoTerminal {
 public:
  /// @throws DeviceError if the system has none left
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  const std::string& path() const { return path_; }
  /// Hands over the machine's side, to be closed by the caller.
  int releaseMachineSide();

 private:
  int machine_ = -1;
  int user_ = -1;
  std::string path_;
};

/// A symbolic link that is removed with the object.
class SymbolicLink {
 public:
  explicit SymbolicLink(std::string path) : path_(std::move(path)) {}
  ~SymbolicLink();
  SymbolicLink(const SymbolicLink&) = delete;
  SymbolicLink& operator=(const SymbolicLink&) = delete;

  /// Makes the link, or makes it point elsewhere.
  /// @throws FileError if it cannot be made, or the path holds something that is no symbolic link
  void pointTo(const std::string& target);
  void remove();
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool is_made_ = false;
};

}  // namespace lamina
