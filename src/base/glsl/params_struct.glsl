// Begins the fields of a parameter table inside a GLSL struct: include the `.params` file next, then params_undefine.h.
// A table may be empty and a GLSL struct may not: end the struct with `uint table_end;`.
#define PARAM_FLOAT(name, value, lo, hi, update, help) float name;
#define PARAM_INT(name, value, lo, hi, update, help) int name;
#define PARAM_BOOL(name, value, update, help) uint name;
#define PARAM_CHOICE2(name, a, b, value, update, help) uint name;
#define PARAM_CHOICE3(name, a, b, c, value, update, help) uint name;
#define PARAM_CHOICE4(name, a, b, c, d, value, update, help) uint name;
#define PARAM_CHOICE5(name, a, b, c, d, e, value, update, help) uint name;
