// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "lamina/journal/cell_journal.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

void checkAudit(const std::string& folder, Chosen& chosen) {
  const CellJournal journal = CellJournal::read(folder + "/cell.db");
  const std::optional<std::int64_t> bad = journal.firstBadAudit();
  chosen.exit_code = bad ? 1 : 0;
  if (chosen.format == OutputFormat::Json) {
    nlohmann::ordered_json json;
    json["is_whole"] = !bad;
    json["first_bad_row"] = bad ? nlohmann::ordered_json(*bad) : nullptr;
    std::printf("%s\n", json.dump(2).c_str());
  } else if (bad) {
    std::printf("%s/cell.db: row %lld of the audit was edited, removed or added\n", folder.c_str(),
                static_cast<long long>(*bad));
  } else {
    std::printf("%s/cell.db: the audit is whole\n", folder.c_str());
  }
}

}  // namespace

void addAudit(CLI::App& app, Chosen& chosen) {
  auto folder = std::make_shared<std::string>();
  CLI::App* audit = app.add_subcommand("audit", kAuditDescription);
  audit->add_option("folder", *folder, "Folder of the cell's journal (journal.folder)")->required();
  addJsonFlag(*audit, chosen);
  audit->callback([folder, &chosen] { chosen.run = [folder, &chosen] { checkAudit(*folder, chosen); }; });
}

}  // namespace lamina::cli
