// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/annotations/words_of_dialect.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "planning/flow/role_advances.hpp"

namespace lamina {

bool hasWordForAdvance(const JobSettings& settings) {
  const GcodeDialect dialect = gcodeDialects().find(settings.program.dialect);
  return dialect.has_extruder &&
         (settings.flow.advance_word != AdvanceWord::Dialect || !dialect.advance.empty());
}

void requireWordsOfDialect(const std::string& output, const JobSettings& settings) {
  if (!isGcodeFile(output)) return;
  const std::string& name = settings.program.dialect;
  const GcodeDialect dialect = gcodeDialects().find(name);
  const std::string with = " with program.dialect '" + name + "'";
  if (hasAdvance(settings.flow) && !hasWordForAdvance(settings))
    throw InvalidConfig((settings.flow.advance_s > 0.0
                             ? "flow.advance_s is " + numberText(settings.flow.advance_s) + " s"
                             : std::string("flow.advance_by_role states advances")) +
                        with + ", which has no word for it; expected none" +
                        (dialect.has_extruder ? ", or the word of its firmware as flow.advance_word" : ""));
  const std::string labels = toString(settings.plate.labels);
  if (settings.plate.labels != ObjectLabels::None && labels != dialect.labels)
    throw InvalidConfig("plate.labels is '" + labels + "'" + with +
                        ", which does not know them; expected 'none'" +
                        (dialect.labels.empty() ? "" : " or '" + dialect.labels + "'"));
}

}  // namespace lamina
