// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Length of bead [mm] within which the place where a job that was cut off begins is the one that a person
/// has confirmed: what a robot at rest reports varies less. The unit and who drives the job compare by it.
inline constexpr double kConfirmedPlace = 0.5;

}  // namespace lamina
