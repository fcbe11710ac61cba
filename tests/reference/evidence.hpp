// The pictures of a comparison as PNG files.
#pragma once

#include <string>

#include "compare.hpp"
#include "result.hpp"

namespace zstrip::reference {

/// Writes NAME.zstrip.png, NAME.reference.png and NAME.difference.png and returns the path without these endings.
/// The difference: grey background; certain pixels white, light grey where the RGB565 codes differ; plausible pixels
/// yellow; slivers green; foreign ones and wrong shading red; wrong coverage blue.
sim::Result<std::string> write_evidence(const std::string& name, const RendererPicture& picture,
                                        const ReferencePicture& reference, const Comparison& comparison);

}  // namespace zstrip::reference
