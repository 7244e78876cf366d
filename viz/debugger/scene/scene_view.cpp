#include "viz/debugger/scene/scene_view.h"

#include "viz/debugger/scene/scene_view_of.h"

namespace kerf {

std::unique_ptr<SceneView> make_scene_view(const GlFunctions& gl, Run& run) {
  return std::visit(
      [&]<int D>(RunOf<D>* of) -> std::unique_ptr<SceneView> {
        return std::make_unique<SceneViewOf<D>>(gl, *of);
      },
      run.self());
}

}  // namespace kerf
