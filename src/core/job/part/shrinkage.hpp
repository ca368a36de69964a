// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/part/source_part.hpp"

namespace lamina {

/// Whether the settings scale a part before it is sliced.
bool changesSize(const CompensationSettings& settings);

/// The part scaled to have its nominal size after shrinking: about the middle of its underside, along the
/// axes of the layers' frame.
SourcePart grownForShrinkage(SourcePart source, const JobSettings& settings);

/// A sentence on the sizes [mm] as drawn and as deposited.
std::string sizeNote(const Point3& drawn, const Point3& deposited);

}  // namespace lamina
