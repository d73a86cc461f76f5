// Pictures a second on two threads; the product's floor is 60 full frames and 1,000 crops.

#include <benchmark/benchmark.h>

#include "conceptplan/domain/rendering/renderer.hpp"

namespace conceptplan {
namespace {

/// Every object type and texture once, so that no case pays for building them.
void warmUp(Renderer& renderer) {
  World world;
  for (int type = 0; type < static_cast<int>(kNumObjectTypes); ++type) {
    world.objects.push_back({static_cast<ObjectType>(type), {type % 3, type / 3}, 0, 0, 0});
  }
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    renderer.render(world, {seed, RenderDomain::kStandard});
    renderer.render(world, {seed, RenderDomain::kShifted});
  }
}

/// A level-4 task: target, two obstacles and the dyer.
World task(int variant) {
  World world;
  world.objects = {
      {static_cast<ObjectType>(variant % 7), {variant % 3, 0}, variant % 4, variant % 6, 3},
      {static_cast<ObjectType>((variant + 3) % 7), {(variant + 1) % 3, 2}, 1, 2, 2},
      {static_cast<ObjectType>((variant + 5) % 7), {(variant + 2) % 3, 3}, 2, 3, 1},
      {ObjectType::kDyer, {variant % 3, 4}, 0, 4, 2}};
  return world;
}

/// A frame a task: room, light and objects all new.
void freshFrames(benchmark::State& state, RenderDomain domain) {
  Renderer renderer;
  warmUp(renderer);
  int k = state.thread_index();
  for (auto _ : state) {
    benchmark::DoNotOptimize(renderer.render(task(k), {static_cast<std::uint64_t>(k), domain}));
    k += state.threads();
  }
  state.SetItemsProcessed(state.iterations());
}

/// The frames of one task: the room stays.
void framesOfOneTask(benchmark::State& state) {
  Renderer renderer;
  warmUp(renderer);
  int k = state.thread_index();
  for (auto _ : state) {
    benchmark::DoNotOptimize(renderer.render(task(k), {7, RenderDomain::kStandard}));
    k += state.threads();
  }
  state.SetItemsProcessed(state.iterations());
}

/// Crops of the concept set: every one another combination and appearance.
void foregroundCrops(benchmark::State& state) {
  Renderer renderer;
  warmUp(renderer);
  int k = state.thread_index();
  for (auto _ : state) {
    const ObjectState object{
        static_cast<ObjectType>(k % 8), {k % 3, k % 5}, (k / 3) % 4, (k / 5) % 6, (k / 7) % 4};
    benchmark::DoNotOptimize(renderer.renderForeground(
        Workbench{}, object, {static_cast<std::uint64_t>(k), RenderDomain::kStandard}));
    k += state.threads();
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK_CAPTURE(freshFrames, standard, RenderDomain::kStandard)->Threads(2)->UseRealTime();
BENCHMARK_CAPTURE(freshFrames, shifted, RenderDomain::kShifted)->Threads(2)->UseRealTime();
BENCHMARK(framesOfOneTask)->Threads(2)->UseRealTime();
BENCHMARK(foregroundCrops)->Threads(2)->UseRealTime();

}  // namespace
}  // namespace conceptplan
