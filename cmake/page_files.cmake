# Writes the files of the operator's page as a source: cmake -DFOLDER= -DFILES=a;b -DOUTPUT= -P page_files.cmake
set(types_html "text/html; charset=utf-8")
set(types_css "text/css; charset=utf-8")
set(types_js "text/javascript; charset=utf-8")
set(types_svg "image/svg+xml")

set(arrays)
set(rows)
foreach(file ${FILES})
  file(READ ${FOLDER}/${file} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(MAKE_C_IDENTIFIER ${file} name)
  string(REGEX MATCH "[a-z]+$" suffix ${file})
  string(APPEND arrays "constexpr char k_${name}[] = {${bytes}};\n")
  string(APPEND rows "      {\"${file}\", \"${types_${suffix}}\", {k_${name}, sizeof k_${name}}},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made from src/web_page by cmake/page_files.cmake.
// NOLINTBEGIN(readability-identifier-naming): names are those of the files.
#include \"page_files.hpp\"

namespace {
${arrays}}  // namespace

std::vector<lamina::PageFile> lamina::pageFiles() {
  return {
${rows}  };
}
// NOLINTEND(readability-identifier-naming)
")
