// murosimf-view SCENARIO: a window onto a game.

#include "murosimf-view/run_viewer.h"

int main(int count, char** words) { return murosimf::runViewer(count, words, murosimf::allViewerParts()); }
