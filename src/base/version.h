// Which gnomon this is: recorded with every result.
#pragma once

namespace gnomon {

const char* version();     // of the project
const char* commit();      // short hash, "+" at the end for a changed tree, "unknown" outside git
const char* build_type();  // "release", "debug", ...

}  // namespace gnomon
