#pragma once

/// @file The panels of the window, in the order of its menu.

#include <memory>
#include <vector>

#include "murosimf-view/panel.h"

namespace murosimf {

std::unique_ptr<Panel> makeSimulationPanel();  ///< time, speed, stages
std::unique_ptr<Panel> makeObjectsPanel();     ///< tree, constants, variables
std::unique_ptr<Panel> makeRenderersPanel();   ///< what is shown of whom
std::unique_ptr<Panel> makeRobotsPanel();      ///< levels of detail
std::unique_ptr<Panel> makePlotsPanel();       ///< numbers over time
std::unique_ptr<Panel> makeCamerasPanel();     ///< pictures of robots, with percepts
std::unique_ptr<Panel> makeMapPanel();         ///< what control software believes, against the truth
std::unique_ptr<Panel> makePicturesPanel();    ///< screenshots, videos
std::unique_ptr<Panel> makeRecordingPanel();   ///< shows one in the place of the simulation
std::unique_ptr<Panel> makeHelpPanel();        ///< keys

std::vector<std::unique_ptr<Panel>> makeAllPanels();

}  // namespace murosimf
