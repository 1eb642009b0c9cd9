#pragma once

/// @file The window as a function: a program of one's own shows the modules and renderers that it brings.
///
///     int main(int count, char** words) {
///       murosimf::ViewerParts parts = murosimf::allViewerParts();
///       parts.modules.add<Battery>("battery", "energy", "charge falls with joint speed", Battery::parameters());
///       parts.renderers.add<ChargeRenderer>({"charge", "battery_charge", "self", "how full the battery is"});
///       return murosimf::runViewer(count, words, parts);
///     }
///
/// Words of the command line, keys and scripts are those of murosimf-view (docs/viewer.md).

#include "murosimf/linking/module.h"
#include "murosimf/render/property_renderer.h"
#include "murosimf/scene/world_builder.h"

namespace murosimf {

/// What scenarios can name, and what can be shown of it.
struct ViewerParts {
  ModuleRegistry modules;
  ControlPrograms programs;
  RendererRegistry renderers;
};

/// All that murosimf itself brings.
ViewerParts allViewerParts();

/// Reads the words, opens the window, and returns when it is closed. Faults are told on stderr.
/// @returns 0; 1: the simulation failed, or there is no display; 2: wrong words or a wrong scenario
int runViewer(int count, char** words, const ViewerParts& parts);

}  // namespace murosimf
