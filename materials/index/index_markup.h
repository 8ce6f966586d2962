// Citations as plain text.
#pragma once

#include <string>
#include <string_view>

namespace karat {

// `text` on one line without its HTML (tags, entities) and Markdown (emphasis, links). A link to
// doi.org leaves "doi:..." behind. What only looks like a tag, such as the crystal direction <111>,
// stays.
std::string plain_text(std::string_view text);

}  // namespace karat
