// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "picture/jpeg_module.hpp"

// libjpeg's header needs what these declare.
#include <cstddef>
#include <cstdio>
//
#include <jpeglib.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <vector>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr int kQuality = 90;  // of 100: no blocks are seen round lines

/// The library's own handler ends the process.
[[noreturn]] void refuse(j_common_ptr library) {
  std::array<char, JMSG_LENGTH_MAX> message{};
  library->err->format_message(library, message.data());
  throw InvalidInput("a picture cannot be written as JPEG: " + std::string(message.data()));
}

struct Destroy {
  void operator()(jpeg_compress_struct* library) const { jpeg_destroy_compress(library); }
};

struct Free {
  void operator()(unsigned char* bytes) const { std::free(bytes); }  // NOLINT(cppcoreguidelines-no-malloc)
};

std::string encode(const PixelImage& image) {
  jpeg_compress_struct library{};
  jpeg_error_mgr errors{};
  library.err = jpeg_std_error(&errors);
  errors.error_exit = refuse;
  jpeg_create_compress(&library);
  const std::unique_ptr<jpeg_compress_struct, Destroy> cleared(&library);
  unsigned char* written = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&library, &written, &size);
  library.image_width = static_cast<JDIMENSION>(image.width);
  library.image_height = static_cast<JDIMENSION>(image.height);
  library.input_components = 3;
  library.in_color_space = JCS_RGB;
  jpeg_set_defaults(&library);
  jpeg_set_quality(&library, kQuality, TRUE);
  // The same bytes whatever the processor: its fast transforms round differently.
  library.dct_method = JDCT_ISLOW;
  jpeg_start_compress(&library, TRUE);
  std::vector<std::uint8_t> row(3 * static_cast<std::size_t>(image.width));
  while (library.next_scanline < library.image_height) {
    const std::size_t first = row.size() * library.next_scanline;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = image.rgb[first + i];
    std::uint8_t* line = row.data();
    jpeg_write_scanlines(&library, &line, 1);
  }
  jpeg_finish_compress(&library);
  const std::unique_ptr<unsigned char, Free> bytes(written);
  return {written, written + size};
}

}  // namespace
}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::JpegModule kTable{&lamina::encode};
  return &kTable;
}
