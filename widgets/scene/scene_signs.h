#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vector>

namespace hexoderm {

/// The signs on cells and links that findings are about (SkinSigns), flat on the faces in the colour that stands out
/// from each, so that no finding hangs on a colour: a cell that is placed through its links is hatched, one with an
/// error is crossed from corner to corner, one with a warning has a triangle, and a link has a cross in a disc at both
/// of its ports. The middle of a face stays free for its ID. Both faces of a prism have them. No Qt, no OpenGL.
vtkSmartPointer<vtkPolyData> makeSigns(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                       const SceneColors& colors);

}  // namespace hexoderm
