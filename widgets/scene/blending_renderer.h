#pragma once

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>

namespace hexoderm {

/// Blends translucent things in the order of the actors. VTK's own renderer blends in no order, for which it fills more
/// pictures as large as the window and puts them together with shaders of their own; without a graphics card, the
/// window stands still while these are compiled, when the first translucent thing appears. Hexoderm's translucent
/// things are of one colour each, so that no order of them would be seen.
class BlendingRenderer : public vtkOpenGLRenderer {
 public:
  static BlendingRenderer* New() { VTK_STANDARD_NEW_BODY(BlendingRenderer); }

  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* /*framebuffer*/) override {
    UpdateTranslucentPolygonalGeometry();
  }
};

}  // namespace hexoderm
