#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/// The classifier's network (Sec. IV-A.3) as `touchdown train` wrote it. `pattern` has 14 rows of 14 cells in [0, 1];
/// `posterior` receives the probabilities of circle, letter H and other, which sum to 1.
void TouchdownClassifierPosteriors(const float pattern[196], float posterior[3]);

/// The same as `touchdown train --letter rectangle` wrote it, for pads with a solid rectangle in place of the H.
void TouchdownRectangleClassifierPosteriors(const float pattern[196], float posterior[3]);

#ifdef __cplusplus
}
#endif
