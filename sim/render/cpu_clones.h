#pragma once

/// Marks a function of which the compiler makes a second copy, vectorised for CPUs with AVX2. For integers, and for
/// floating-point numbers in the order as written: then both copies give the same.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define TOUCHDOWN_CLONE_FOR_CPUS __attribute__((target_clones("avx2", "default"), optimize("O3")))
#else
#define TOUCHDOWN_CLONE_FOR_CPUS
#endif
