#pragma once

#include <filesystem>

#include "frames/sequence/record_scene.h"
#include "viz/debugger/gui/glfw_window.h"

namespace kerf {

/// Records a scene while a window shows how far it is, and returns where the recording is. Enter ends it with
/// the steps so far; Escape, or closing the window, throws Interrupted, as a signal does. Otherwise as
/// record_scene.
std::filesystem::path record_in_window(const RenderRequest& request, CostOfRecording cost,
                                       GlfwWindow& window);

/// Shows in the window that the file is being opened.
void show_opening(const std::filesystem::path& file, GlfwWindow& window);

}  // namespace kerf
