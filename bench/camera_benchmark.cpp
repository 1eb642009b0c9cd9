// What a camera's picture costs: colour, depth and label of the game of camera_scene.h from a robot's head, one thread.

#include <benchmark/benchmark.h>

#include "algorithms/camera_scene.h"
#include "algorithms/mesh_shapes.h"
#include "murosimf/algorithms/pixel_motion.h"
#include "paired_ratio.h"

namespace murosimf {
namespace {

using camera_scene::cameraPose;

/// A robot's eyes that look about the field.
Pose pan(int frame) { return cameraPose({-0.28, -0.15, 0.5}, 0.35 * sin(0.37 * frame), 0.35); }

/// The picture's size is (width, 3/4 width).
CameraModel distortedCamera(int width) { return camera_scene::headCamera(width, 3 * width / 4); }
/// Without distortion, as wide an angle.
CameraModel straightCamera(int width) {
  const CameraModel lens = distortedCamera(width);
  const double left = -unproject(lens, {-0.5, lens.cy}).x, right = unproject(lens, {lens.width - 0.5, lens.cy}).x;
  return makePinholeCamera(lens.width, lens.height, atan2(left, 1.0) + atan2(right, 1.0));
}

struct Setup {
  explicit Setup(const CameraModel& camera) : rays(camera) {}
  void cast(int frame) { castPicture(rays, scene, pan(frame), {}, options, work, picture); }

  RayTable rays;
  RayScene scene = camera_scene::makeGame();
  CastOptions options;
  PreparedScene work;
  Picture picture;
};

void run(benchmark::State& state, Setup& setup) {
  if (!isSupported(setup.options.lanes)) return state.SkipWithError("this machine has no AVX-512");
  int frame = 0;
  for (auto _ : state) setup.cast(frame++);
  state.counters["Mpx/s"] = benchmark::Counter(1e-6 * static_cast<double>(setup.picture.label.size()),
                                               benchmark::Counter::kIsIterationInvariantRate);
}

void distorted(benchmark::State& state, CastLanes lanes) {
  Setup setup(distortedCamera(static_cast<int>(state.range(0))));
  setup.options.lanes = lanes;
  run(state, setup);
}
BENCHMARK_CAPTURE(distorted, one_lane, CastLanes::kOne)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distorted, avx2, CastLanes::kEight)->Arg(160)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distorted, avx512, CastLanes::kSixteen)->Arg(160)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);

/// The same with one thing more or less, AVX2, 640 x 480.
template <class Change>
void variant(benchmark::State& state, Change change) {
  Setup setup(distortedCamera(640));
  setup.options.lanes = CastLanes::kEight;
  change(setup);
  run(state, setup);
}
BENCHMARK_CAPTURE(variant, noise, [](Setup& s) { s.options.sensor.deviation = 0.01F; })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, ground_shadows, [](Setup& s) {
  s.scene.ground_shadows = true;
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, shadows, [](Setup& s) { s.options.shadows = true; })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, boxes, [](Setup& s) { s.picture.has_boxes = true; })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, parts, [](Setup& s) { s.picture.has_part = true; })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, texture, [](Setup& s) {
  std::vector<std::uint8_t> grass(3UL * 512 * 512);
  for (std::size_t i = 0; i < grass.size(); ++i) grass[i] = static_cast<std::uint8_t>(i * 2654435761U >> 24);
  s.scene.ground.texture = std::make_shared<const GroundTexture>(512, 512, grass);
  s.scene.ground.texture_size = 1;
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, antialias, [](Setup& s) { s.options.antialias = true; })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, colour_only, [](Setup& s) {
  s.picture.has_depth = s.picture.has_label = false;
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, empty_field, [](Setup& s) { s.scene.drawables.clear(); })->Unit(benchmark::kMillisecond);
/// Robots, goals and ball of triangles: 11 000 a robot, those of all robots the same.
BENCHMARK_CAPTURE(variant, meshes, [](Setup& s) {
  mesh_shapes::drawAsMeshes(24, s.scene);
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, meshes_and_shadows, [](Setup& s) {
  mesh_shapes::drawAsMeshes(24, s.scene);
  s.options.shadows = true;
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(variant, robots_22, [](Setup& s) {
  for (int k = 0; k < 16; ++k)
    camera_scene::addRobot({0.4 + 0.1 * k, 0.8 * sin(2.0 * k), 0.5 * k}, {0.2F, 0.6F, 0.8F}, 30 + k, s.scene);
})->Unit(benchmark::kMillisecond);

/// Time with the lens over time without, pictures of equal width of view, taken in turns.
void distortedOverStraight(benchmark::State& state) {
  Setup lens(distortedCamera(static_cast<int>(state.range(0)))),
      straight(straightCamera(static_cast<int>(state.range(0))));
  double with = 0, without = 0;
  int frame = 0;
  for (auto _ : state) {
    const double begin = bench::threadTime();
    lens.cast(frame);
    const double middle = bench::threadTime();
    straight.cast(frame++);
    with += middle - begin, without += bench::threadTime() - middle;
  }
  state.counters["ratio"] = with / without;
}
BENCHMARK(distortedOverStraight)->Arg(160)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);

/// Motion of every pixel, after the picture.
void motion(benchmark::State& state) {
  Setup setup(distortedCamera(640));
  setup.picture.has_part = true;
  setup.cast(0);
  std::vector<Pose> before;
  for (const Drawable& d : setup.scene.drawables) before.push_back(d.X_WS);
  for (auto _ : state) findMotion(setup.rays, setup.scene, pan(0), before, pan(1), setup.picture);
}
BENCHMARK(motion)->Unit(benchmark::kMillisecond);

/// What a picture needs before the first ray.
void prepare(benchmark::State& state) {
  Setup setup(distortedCamera(640));
  int frame = 0;
  for (auto _ : state) prepareScene(setup.rays, setup.scene, pan(frame++), {}, false, setup.work);
}
BENCHMARK(prepare)->Unit(benchmark::kMicrosecond);

void rayTable(benchmark::State& state) {
  const CameraModel camera = distortedCamera(640);
  for (auto _ : state) benchmark::DoNotOptimize(RayTable(camera).tiles());
}
BENCHMARK(rayTable)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace murosimf
