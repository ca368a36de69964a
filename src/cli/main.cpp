// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <iostream>

#include "lamina/base/error.hpp"
#include "subcommand.hpp"

int main(int argc, char** argv) {
  using namespace lamina;
  CLI::App app{"Lamina: from mesh to deposited layers on printers and robots", "lamina"};
  app.require_subcommand(1);
  cli::Run run;
  try {
    app.parse(argc, argv);
    if (run) run();
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (...) {
    const Failure failure = currentFailure();
    std::cerr << "lamina: " << toString(failure.code) << ": " << failure.message << '\n';
    return 1;
  }
}
