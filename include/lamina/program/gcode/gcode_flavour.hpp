// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "lamina/base/registry.hpp"
#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/text_sink.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Writes a toolpath as G-code of linear axes, in the coordinates that the frame's axes give. What it
/// refuses, it refuses before the first piece is written.
/// @throws InvalidInput, InvalidConfig as `writeGcode`
using GcodeFlavour = std::function<void(const Toolpath& toolpath, const ProgramFrame& frame,
                                        const ProgramSettings& settings, const TextSink& sink)>;

/// All flavours of G-code, those of plug-ins too: those of `gcodeDialects` (`writeGcode`), "fullcontrol"
/// (`writeFullControl`). Whoever adds one calls `gcodeFlavours().add("name", write)`.
Registry<GcodeFlavour>& gcodeFlavours();

/// Writes in the flavour that `program.flavour` names.
/// @throws InvalidConfig if there is none of that name; as the flavour
void writeFlavoured(const Toolpath& toolpath, const ProgramFrame& frame, const ProgramSettings& settings,
                    const TextSink& sink);

}  // namespace lamina
