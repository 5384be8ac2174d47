#pragma once

#include <cstdlib>  // defines __GLIBC__ where it is

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hexoderm {

/// Lets the process keep up to 64 MB that it freed, instead of giving every large matrix back to the system and getting
/// the pages anew, emptied one by one, for the next: that is a seventh of what solving 1,260 cells again takes. For
/// programs, at the start of main(); where the C library is not glibc it does nothing.
inline void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kKept_bytes = 64 << 20;
  constexpr int kLargestOnHeap_bytes = 32 << 20;  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, kKept_bytes);
  mallopt(M_MMAP_THRESHOLD, kLargestOnHeap_bytes);
#endif
}

}  // namespace hexoderm
