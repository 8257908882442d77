/// What stands beside a picture in words: numbers as people write them, title lines, the scale bar.
#pragma once

#include <string>
#include <vector>

#include "host/view/canvas.h"

namespace isotouch::view {

inline const Colour kInk = srgb(0x27303B);
inline const Colour kPaleInk = srgb(0x66727F);

/// How much larger than on a picture of 960 x 720 letters and strokes are drawn.
float drawing_scale(const Picture& picture);

/// "12.5", never with more digits than `decimals`, and none behind the point that are zero.
std::string number(double value, int decimals);

/// "0.00231": as many digits as asked for, counted from the first that is not zero.
std::string significant(double value, int digits);

/// 1, 2 or 5 times a power of ten: the largest that is not above `value`.
double round_length(double value);

/// Title and smaller lines in the lower left corner of the picture, the last one lowest.
void draw_caption(Canvas& canvas, const std::string& title, const std::vector<std::string>& lines);

/// A bar with its length in mm, its right end at `end`.
void draw_scale_bar(Canvas& canvas, Point end, double pixel_per_mm, double longest_pixels);

}  // namespace isotouch::view
