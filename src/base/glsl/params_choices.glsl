// Begins the constants of a parameter table's choices (name_value): include the `.params` file next, then params_undefine.h.
#define PARAM_FLOAT(name, value, lo, hi, update, help)
#define PARAM_INT(name, value, lo, hi, update, help)
#define PARAM_BOOL(name, value, update, help)
#define PARAM_CHOICE2(name, a, b, value, update, help) const uint name##_##a = 0u, name##_##b = 1u;
#define PARAM_CHOICE3(name, a, b, c, value, update, help) const uint name##_##a = 0u, name##_##b = 1u, name##_##c = 2u;
#define PARAM_CHOICE4(name, a, b, c, d, value, update, help) \
  const uint name##_##a = 0u, name##_##b = 1u, name##_##c = 2u, name##_##d = 3u;
#define PARAM_CHOICE5(name, a, b, c, d, e, value, update, help) \
  const uint name##_##a = 0u, name##_##b = 1u, name##_##c = 2u, name##_##d = 3u, name##_##e = 4u;
