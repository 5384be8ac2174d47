#pragma once

#include "widgets/scene/scene_content.h"
#include "widgets/style/scene_colors.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vector>

namespace hexoderm {

// Meshes of the cells themselves. No Qt, no OpenGL.

/// The surface with one colour a cell; the sides of prisms are darker, and their backs greyed too. Shares points and
/// polygons with the content's.
vtkSmartPointer<vtkPolyData> makeColoredSurface(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                                const SceneColors& colors);
/// The same with SceneContent::bricks, which must be there.
vtkSmartPointer<vtkPolyData> makeColoredBricks(const SceneContent& content, const std::vector<Rgb>& front_colors);

/// Sides, backs and undersides, of the front face's colour.
inline constexpr double kUndersideShade = 0.70;
/// What the back of a cell is greyed with, and how much of it.
Rgb backGrey(const SceneColors& colors);
inline constexpr double kBackGrey = 0.55;

/// Ports as discs (joined to a neighbour by a used link) or rings (free), flat on the front faces in the colour that
/// stands out from each face.
vtkSmartPointer<vtkPolyData> makePortMarks(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                           const SceneColors& colors);
/// A ring on the origin of each patch, likewise.
vtkSmartPointer<vtkPolyData> makeOriginMarks(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                             const SceneColors& colors);

/// The signs on cells and links that findings are about (SkinSigns), flat on the faces in the colour that stands out
/// from each, so that no finding hangs on a colour: a cell that is placed through its links is hatched, one with an
/// error is crossed from corner to corner, one with a warning has a triangle, and a link has a cross in a disc at both
/// of its ports. The middle of a face stays free for its ID. Both faces of a prism have them. No Qt, no OpenGL.
vtkSmartPointer<vtkPolyData> makeSigns(const SceneContent& content, const std::vector<Rgb>& front_colors,
                                       const SceneColors& colors);

}  // namespace hexoderm
