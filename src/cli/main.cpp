// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lamina/base/error.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

void printFailure(const Failure& failure, OutputFormat format) {
  std::fprintf(stderr, "lamina: %s: %s\n", toString(failure.code), failure.message.c_str());
  if (format == OutputFormat::Text) return;
  const nlohmann::json error = {{"error", {{"code", toString(failure.code)}, {"message", failure.message}}}};
  std::printf("%s\n", error.dump().c_str());
}

int runCommandLine(int argc, char** argv) {
  CLI::App app{"Lamina: from mesh to deposited layers on printers and robots", "lamina"};
  app.require_subcommand(1);
  Chosen chosen;
  addEmulate(app, chosen);
  addInfo(app, chosen);
  addPart(app, chosen);
  addPreview(app, chosen);
  addSlice(app, chosen);
  addStream(app, chosen);
  try {
    app.parse(argc, argv);
    chosen.run();
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (...) {
    printFailure(currentFailure(), chosen.format);
    return 1;
  }
}

}  // namespace
}  // namespace lamina::cli

int main(int argc, char** argv) { return lamina::cli::runCommandLine(argc, argv); }
