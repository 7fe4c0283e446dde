// Parameters of the laboratory itself.
#pragma once

#include "base/params.h"

namespace gnomon {

namespace light_params {
#define GNOMON_PARAMS_FILE "lab/light.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace light_params

namespace camera_params {
#define GNOMON_PARAMS_FILE "lab/camera.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace camera_params

namespace reference_params {
#define GNOMON_PARAMS_FILE "lab/reference.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace reference_params

namespace measure_params {
#define GNOMON_PARAMS_FILE "lab/measure.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace measure_params

}  // namespace gnomon
