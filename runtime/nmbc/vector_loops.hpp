// SPDX-License-Identifier: MIT
/// What loops over entries of fields say, so that compilers make vectors of them.
#pragma once

/// Before a loop over entries: what one writes, no other one reads. GCC would find that out for few
/// rows only, while the loop runs.
#if defined(__clang__)
#define NMBC_NO_ENTRY_NEEDS_ANOTHER _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define NMBC_NO_ENTRY_NEEDS_ANOTHER _Pragma("GCC ivdep")
#else
#define NMBC_NO_ENTRY_NEEDS_ANOTHER
#endif

/// Of what is in loops over entries, and of short loops: where a call is left in place, which GCC
/// decides anew in every program, the loop around it has no vectors.
#if defined(__GNUC__)
#define NMBC_INLINED [[gnu::always_inline]] inline
#else
#define NMBC_INLINED inline
#endif
