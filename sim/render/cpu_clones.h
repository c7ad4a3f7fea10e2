#pragma once

/// Marks a function for function multiversioning: a second copy is vectorized for CPUs with AVX2. Use it only for
/// integers and for floating-point operations in a fixed order, for which both copies give the same result.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define TOUCHDOWN_CLONE_FOR_CPUS __attribute__((target_clones("avx2", "default"), optimize("O3")))
#else
#define TOUCHDOWN_CLONE_FOR_CPUS
#endif
