// The assembly for small triangles against the C++ that it stands for.
#pragma once

namespace zstrip::board {

/// Sets up and scans 40,000 pseudo-random triangles both ways and compares planes, depth and pixels. 0 if all are
/// equal; says what differs. A core without Thumb-2 has nothing to compare, which it says.
int check_small_triangles();

}  // namespace zstrip::board
