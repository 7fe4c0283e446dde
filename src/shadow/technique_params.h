// Params and param_table_storage() of the technique whose folder this is included from (the build names the table). No guard.
#define GNOMON_PARAMS_FILE GNOMON_TECHNIQUE_PARAMS
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
