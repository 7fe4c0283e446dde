// Part of base/params_define.h and of glsl/params.glsl: ends one reading of a table.
#undef PARAM_FLOAT
#undef PARAM_INT
#undef PARAM_BOOL
#undef PARAM_CHOICE2
#undef PARAM_CHOICE3
#undef PARAM_CHOICE4
#undef PARAM_CHOICE5
