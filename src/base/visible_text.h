// Text from files, made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace gnomon {

// Control characters - of which a terminal would make colours and cursor moves, and a C string its end - and bytes that are no
// UTF-8 become text: "\x1b[31m" reads as those six characters. Line breaks and tabs stay. Text that is fit already is
// unchanged.
std::string visible_text(std::string_view text);
// The same for a name in a table: line breaks and tabs become text too.
std::string visible_line(std::string_view text);

}  // namespace gnomon
