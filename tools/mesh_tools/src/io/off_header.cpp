#include "off_header.h"

#include <string_view>
#include <vector>

#include "formats.h"

namespace mesh_tools::io {

OffHeader read_off_header(LineReader& reader) {
  std::vector<std::string_view> words;
  if (!reader.next(words)) reader.fail("holds no OFF header");
  std::string_view keyword = words[0];
  if (keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF")
    reader.fail("the file must begin with the word OFF, CNOFF, COFF or NOFF");
  OffHeader header;
  for (std::string_view prefix = keyword.substr(0, keyword.size() - 3); !prefix.empty();) {
    if (prefix.substr(0, 2) == "ST") {
      header.texture = true;
      prefix.remove_prefix(2);
      continue;
    }
    if (prefix[0] == 'C')
      header.colors = true;
    else if (prefix[0] == 'N')
      header.normals = true;
    else
      reader.fail("header '" + printable(keyword) + "' is not supported; allowed prefixes are ST, C and N");
    prefix.remove_prefix(1);
  }
  words.erase(words.begin());
  if (words.size() == 1 && words[0] == "BINARY") reader.fail("binary OFF is not supported; text is");
  if (words.empty() && !reader.next(words)) reader.fail("the counts of vertices and faces are missing");
  if (words.size() < 2) reader.fail("the counts of vertices and faces are missing");
  header.vertices = reader.integer(words[0]);
  header.faces = reader.integer(words[1]);
  if (header.vertices < 0 || header.faces < 0) reader.fail("a count is negative");
  return header;
}

}  // namespace mesh_tools::io
