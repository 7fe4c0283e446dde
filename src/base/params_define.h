// Includes the table GNOMON_PARAMS_FILE twice and defines, in the namespace at hand:
//   struct Params        one 4-byte field per parameter, defaults filled in
//   k_param_table        std::span<const ParamInfo> of the same lines
// No include guard: each table is included where its owner is defined. base/params.h must be included before.
// Lines of a table: PARAM_FLOAT(name, default, min, max, live|rebuild, "help [unit]"), PARAM_INT likewise,
// PARAM_BOOL(name, default, update, "help"), PARAM_CHOICE2..5(name, value..., default, update, "help").

enum : uint32_t {
#define PARAM_FLOAT(name, value, lo, hi, update, help)
#define PARAM_INT(name, value, lo, hi, update, help)
#define PARAM_BOOL(name, value, update, help)
#define PARAM_CHOICE2(name, a, b, value, update, help) name##_##a = 0, name##_##b,
#define PARAM_CHOICE3(name, a, b, c, value, update, help) name##_##a = 0, name##_##b, name##_##c,
#define PARAM_CHOICE4(name, a, b, c, d, value, update, help) name##_##a = 0, name##_##b, name##_##c, name##_##d,
#define PARAM_CHOICE5(name, a, b, c, d, e, value, update, help) name##_##a = 0, name##_##b, name##_##c, name##_##d, name##_##e,
#include GNOMON_PARAMS_FILE
#include "base/params_undefine.h"
  k_choices_end
};

struct Params {
#define PARAM_FLOAT(name, value, lo, hi, update, help) float name = static_cast<float>(value);
#define PARAM_INT(name, value, lo, hi, update, help) int32_t name = value;
#define PARAM_BOOL(name, value, update, help) uint32_t name = value;
#define PARAM_CHOICE2(name, a, b, value, update, help) uint32_t name = name##_##value;
#define PARAM_CHOICE3(name, a, b, c, value, update, help) uint32_t name = name##_##value;
#define PARAM_CHOICE4(name, a, b, c, d, value, update, help) uint32_t name = name##_##value;
#define PARAM_CHOICE5(name, a, b, c, d, e, value, update, help) uint32_t name = name##_##value;
#include GNOMON_PARAMS_FILE
#include "base/params_undefine.h"
};

inline const std::vector<::gnomon::ParamInfo>& param_table_storage() {
  using enum ::gnomon::ParamType;
  using enum ::gnomon::ParamUpdate;
  static const std::vector<::gnomon::ParamInfo> table = {
#define PARAM_FLOAT(name, value, lo, hi, update, help) {#name, float_, value, lo, hi, update, help},
#define PARAM_INT(name, value, lo, hi, update, help) {#name, int_, value, lo, hi, update, help},
#define PARAM_BOOL(name, value, update, help) {#name, bool_, value, 0, 1, update, help},
#define PARAM_CHOICE2(name, a, b, value, update, help) {#name, choice, name##_##value, 0, 1, update, help, {#a, #b}},
#define PARAM_CHOICE3(name, a, b, c, value, update, help) {#name, choice, name##_##value, 0, 2, update, help, {#a, #b, #c}},
#define PARAM_CHOICE4(name, a, b, c, d, value, update, help) \
  {#name, choice, name##_##value, 0, 3, update, help, {#a, #b, #c, #d}},
#define PARAM_CHOICE5(name, a, b, c, d, e, value, update, help) \
  {#name, choice, name##_##value, 0, 4, update, help, {#a, #b, #c, #d, #e}},
#include GNOMON_PARAMS_FILE
#include "base/params_undefine.h"
  };
  return table;
}
