// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// A machine's description as built into the library.
struct MachineText {
  std::string name;
  std::string urdf;
};

/// The files of `urdf/`, in alphabetical order.
const std::vector<MachineText>& machineTexts();

}  // namespace lamina
