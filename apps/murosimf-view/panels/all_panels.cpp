#include "murosimf-view/panels/all_panels.h"

namespace murosimf {

std::vector<std::unique_ptr<Panel>> makeAllPanels() {
  std::vector<std::unique_ptr<Panel>> all;
  for (const auto make : {makeSimulationPanel, makeObjectsPanel, makeRenderersPanel, makeRobotsPanel, makePlotsPanel,
                          makeCamerasPanel, makeMapPanel, makePicturesPanel, makeRecordingPanel, makeHelpPanel}) {
    all.push_back(make());
  }
  return all;
}

}  // namespace murosimf
