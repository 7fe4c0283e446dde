// The numbers of the table: integers, which are added exactly. Sums over the whole map overflow, and that is no harm:
// differences are right modulo 2^32 as long as the sum over the square itself fits (Lauritzen 2007, section 8.5). So a narrow
// read leaves more bits.
#ifndef GNOMON_SAVSM_FIXED_GLSL
#define GNOMON_SAVSM_FIXED_GLSL

// Bits after the point: the square, with fractions at its edges, touches up to (ceil(width) + 1)^2 texels.
int savsm_bits(float width) {
  uint side = uint(ceil(width)) + 2u;
  return 31 - findMSB(side * side - 1u);
}

// Depth, and its squared distance from the middle of the range (times 4). The square is that of the rounded depth: the rounding
// of the mean then costs the variance nothing.
uvec2 savsm_fixed(float linear, int bits) {
  uint one = 1u << bits;
  uint depth = min(uint(clamp(linear, 0.0, 1.0) * float(one) + 0.5), one - 1u);
  int from_middle = int(2u * depth) - int(one);
  uint high, low;
  umulExtended(uint(abs(from_middle)), uint(abs(from_middle)), high, low);
  return uvec2(depth, min((high << (32 - bits)) | (low >> bits), one - 1u));
}

#endif
