// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/resident_pages.hpp"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace lamina {
namespace {

/// What is looked for in the files that are loaded, and what is found.
struct Release {
  std::size_t page_bytes = 0;
  bool spares_code = false;
  std::size_t looked_at_bytes = 0;
};

/// The loader states places as numbers: there is no pointer to begin with.
template <class Kind>
Kind* placeOf(std::size_t address) {
  return reinterpret_cast<Kind*>(address);  // NOLINT(performance-no-int-to-ptr)
}

/// Debuggers write into code: what they wrote would be gone with its page.
bool isTraced() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("TracerPid:", 0) == 0) return line.find_first_of("123456789") != std::string::npos;
  return true;
}

/// Code or constants that the loader had to write into would come back without what it wrote.
bool isWrittenByLoader(const dl_phdr_info& object) {
  const ElfW(Phdr)* const end = object.dlpi_phdr + object.dlpi_phnum;
  const ElfW(Phdr)* const dynamic =
      std::find_if(object.dlpi_phdr, end, [](const ElfW(Phdr) & each) { return each.p_type == PT_DYNAMIC; });
  if (dynamic == end) return true;
  const auto* entry = placeOf<const ElfW(Dyn)>(object.dlpi_addr + dynamic->p_vaddr);
  for (; entry->d_tag != DT_NULL; ++entry)
    if (entry->d_tag == DT_TEXTREL || (entry->d_tag == DT_FLAGS && (entry->d_un.d_val & DF_TEXTREL) != 0))
      return true;
  return false;
}

int releaseObject(dl_phdr_info* object, std::size_t /*size*/, void* of) {
  Release& release = *static_cast<Release*>(of);
  if (isWrittenByLoader(*object)) return 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    const bool is_code = (segment.p_flags & PF_X) != 0;
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_W) != 0 || (is_code && release.spares_code))
      continue;
    const std::size_t begin = (object->dlpi_addr + segment.p_vaddr) / release.page_bytes * release.page_bytes;
    const std::size_t bytes = object->dlpi_addr + segment.p_vaddr + segment.p_memsz - begin;
    if (madvise(placeOf<void>(begin), bytes, MADV_DONTNEED) == 0) release.looked_at_bytes += bytes;
  }
  return 0;
}

}  // namespace

std::size_t releaseStartPages() {
  Release release;
  release.page_bytes = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  release.spares_code = isTraced();
  dl_iterate_phdr(releaseObject, &release);
  return release.looked_at_bytes;
}

}  // namespace lamina
