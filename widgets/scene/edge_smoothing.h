#pragma once

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace hexoderm {

/// Whether the edges in all that this window draws are smoothed after drawing, by VTK's FXAA. In software OpenGL that
/// takes longer than the drawing.
inline void setSmoothed(vtkRenderWindow& window, bool smoothed) {
  vtkRendererCollection* renderers = window.GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* renderer = renderers->GetNextItem()) renderer->SetUseFXAA(smoothed);
}

}  // namespace hexoderm
