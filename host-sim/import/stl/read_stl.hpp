// Reads an STL file, in text or bytes, with the colours of Magics and VisCAM.
#pragma once

#include <string_view>

#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Bytes are a header of 80, the number of triangles, and 50 for each: a normal, three corners (floats), and a colour
/// of 15 bits that counts if bit 15 is set. With `COLOR=` in the header, as Magics writes it, bit 15 has the opposite
/// meaning, and stands for that colour. The number may be 0 or too large: the triangles in the file count. Text is read
/// word by word, in any case of letters and with any line ends. `turn` is applied to all. A failure's message starts
/// with a verb.
Result<SourceModel> read_stl(std::string_view file, const Affine& turn);

}  // namespace zstrip::sim
