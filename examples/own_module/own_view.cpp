// murosimf-view with a module and a renderer of its own: own_view SCENARIO

#include "charge_renderer.h"
#include "murosimf-view/run_viewer.h"

int main(int count, char** words) {
  murosimf::ViewerParts parts = murosimf::allViewerParts();
  addBattery(parts.modules);
  addChargeRenderer(parts.renderers);
  return murosimf::runViewer(count, words, parts);
}
