#pragma once

#include <QImage>
#include <QRect>
#include <vector>

namespace hexoderm {

/// How far what each pixel shows is from the eye.
struct DepthPicture {
  int width = 0;
  int height = 0;
  std::vector<float> depth_m;  ///< row by row from the top; infinity where there is nothing
};

/// What the depths in a picture that OpenGL has drawn mean.
struct HollowSight {
  double near_m = 0;
  double far_m = 1;
  bool parallel = false;
  double full_m = 0;             ///< see shadeHollows()
  std::vector<QRect> elsewhere;  ///< other things are drawn there, which have no depth; rows from the top
};

/// `depths`: row by row from the bottom, 0 at near_m to 1 at far_m, where there is nothing.
DepthPicture depthPicture(const std::vector<float>& depths, const QSize& size, const HollowSight& sight);

/// The picture with what lies deeper than its surroundings darkened, as it is where light comes from all around: gaps
/// between cells, and cells that stand lower than their neighbours. A plane has no hollows, however it is tilted.
/// `full_m`: a hollow of this depth is as dark as any. For Format_RGB32 of the depth's size; on the processor, as
/// smoothEdges() is and for the same reason.
QImage shadeHollows(const QImage& picture, const DepthPicture& depth, double full_m);

}  // namespace hexoderm
