#include "widgets/blending_renderer.h"

#include <vtkObjectFactory.h>

namespace hexoderm {

vtkStandardNewMacro(BlendingRenderer)

    void BlendingRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* /*framebuffer*/) {
  UpdateTranslucentPolygonalGeometry();
}

}  // namespace hexoderm
