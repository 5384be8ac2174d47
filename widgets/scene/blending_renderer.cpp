#include "widgets/scene/blending_renderer.h"

#include <vtkObjectFactory.h>

namespace hexoderm {

BlendingRenderer* BlendingRenderer::New() { VTK_STANDARD_NEW_BODY(BlendingRenderer); }

void BlendingRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* /*framebuffer*/) {
  UpdateTranslucentPolygonalGeometry();
}

}  // namespace hexoderm
