// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause

// Leaks of libraries that the leak sanitizer shall not report: lib3mf 1.8 never closes the entries of a 3MF
// archive (480 bytes a file); fontconfig keeps its patterns for the life of the program.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libzip.so\nleak:libfontconfig.so\n"; }
