// Parameters of the laboratory itself.
#pragma once

#include "base/params.h"

namespace gnomon {

namespace light_params {
#define GNOMON_PARAMS_FILE "lab/view/light.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace light_params

namespace camera_params {
#define GNOMON_PARAMS_FILE "lab/view/camera.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace camera_params

namespace reference_params {
#define GNOMON_PARAMS_FILE "lab/experiment/reference.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace reference_params

namespace measure_params {
#define GNOMON_PARAMS_FILE "lab/experiment/measure.params"
#include "base/params_define.h"
#undef GNOMON_PARAMS_FILE
}  // namespace measure_params

}  // namespace gnomon
