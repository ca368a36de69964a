// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/reader/rapid_source.hpp"

namespace lamina {
namespace {

void readProcedure(RapidCursor& cursor, RapidSource& source) {
  RapidProcedure procedure;
  procedure.module = source.files.size() - 1;
  procedure.comments = cursor.takeComments();
  const std::size_t line = cursor.line();
  const std::string name = cursor.takeName("the name of a procedure");
  if (source.procedures.count(name) != 0)
    cursor.refuseAt(line, "procedure '" + name + "' stands twice; expected once");
  cursor.expect("(");
  cursor.expect(")");
  while (!cursor.takeWord("endproc")) readRapidStatement(cursor, source, procedure);
  if (source.is_conditional) cursor.refuse("ENDIF before ENDPROC");
  source.procedures.emplace(name, std::move(procedure));
}

}  // namespace

void readRapidModule(RapidCursor& cursor, RapidSource& source) {
  cursor.expectWord("module");
  cursor.takeName("the name of the module");
  while (cursor.takeWord("pers") || cursor.takeWord("const") || cursor.takeWord("var")) {
    cursor.recognise();
    readRapidDeclaration(cursor, source);
  }
  if (source.procedures.empty()) source.head = cursor.takeComments();
  while (cursor.takeWord("proc")) {
    cursor.recognise();
    readProcedure(cursor, source);
  }
  if (!cursor.takeWord("endmodule")) cursor.refuse("PROC, ENDMODULE, or data before the first procedure");
  if (!cursor.isAtEnd()) cursor.refuse("nothing after ENDMODULE");
}

}  // namespace lamina
