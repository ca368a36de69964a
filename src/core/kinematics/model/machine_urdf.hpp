// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace lamina {

/// A machine's description that is built into the library; its texts are static.
struct MachineText {
  std::string_view name;
  std::string_view urdf;
};

/// The files of `urdf/` that `machineFromUrdf` reads, in alphabetical order.
const std::vector<MachineText>& machineTexts();

/// The files of `urdf/` that are not read by `machineFromUrdf`: arms and platforms, in alphabetical order.
const std::vector<MachineText>& robotTexts();

}  // namespace lamina
