#pragma once

#include "widgets/style/palette.h"
#include "widgets/style/scene_colors.h"

#include <vtkInteractorObserver.h>
#include <vtkSmartPointer.h>

namespace hexoderm {

/// The colours of a 3D scene, derived from those of the theme.
SceneColors sceneColors(Theme theme);

/// The trackball, without commands by letters: keys belong to the window.
vtkSmartPointer<vtkInteractorObserver> makeSceneInteractorStyle();

}  // namespace hexoderm
