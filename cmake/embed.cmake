# cmake -D output=FILE.cpp -D "files=a,b" -P embed.cmake: a source file that holds other files' bytes,
# for apps/karat/embedded_file.h. A file's name is its last part.
set(arrays "")
set(entries "")
set(number 0)
string(REPLACE "," ";" files "${files}")
foreach(file ${files})
  file(READ "${file}" bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  get_filename_component(name "${file}" NAME)
  string(APPEND arrays "constexpr unsigned char kFile${number}[] = {${bytes}};\n")
  string(APPEND entries "    {\"${name}\", {reinterpret_cast<const char*>(kFile${number}), sizeof kFile${number}}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE "${output}" "// Written by cmake/embed.cmake.
#include \"apps/karat/embedded_file.h\"

#include <map>
#include <stdexcept>

namespace karat {
namespace {

${arrays}
const std::map<std::string_view, std::string_view> kFiles{
${entries}};

}  // namespace

std::string_view embedded_file(std::string_view name) { return kFiles.at(name); }

}  // namespace karat
")
