// The compiler's intrinsics for SSE2, without the C library; only for the sources of vectors.
#pragma once

#include "zstrip/kernels/processor.hpp"

#if ZSTRIP_HAS_SSE2
// GCC's header includes <stdlib.h> for aligned allocation, which nothing here needs.
#if !defined(_MM_MALLOC_H_INCLUDED)
#define _MM_MALLOC_H_INCLUDED  // NOLINT(bugprone-reserved-identifier)
#endif
#include <emmintrin.h>
#endif
