#include "conceptplan/pipeline/model.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"
#include "integration/pipeline/temporary_folder.hpp"

namespace conceptplan {
namespace {

const Model& shippedModel() {
  static const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  return model;
}

World cupAndPot() {
  World world;
  world.objects = {{ObjectType::kCup, {0, 1}, 1, 3, 3}, {ObjectType::kPot, {2, 3}, 2, 0, 2}};
  return world;
}

TEST(Model, ReadsTheSymbolsOfARenderedPicture) {
  Renderer renderer;
  const Percept percept = shippedModel().perceive(renderer.render(cupAndPot(), {11, {}}));
  ASSERT_EQ(percept.instances, (std::vector<std::uint8_t>{1, 2}));
  const SymbolGrounding& grounding = shippedModel().symbolic().grounding;
  const Symbols cup = mostProbable(percept.beliefs[0]), pot = mostProbable(percept.beliefs[1]);
  EXPECT_EQ(grounding.cell(cup), (Cell{0, 1}));
  EXPECT_EQ(grounding.cell(pot), (Cell{2, 3}));
  EXPECT_EQ(grounding.name(Concept::kColor, cup[index(Concept::kColor)]), "cyan");
  EXPECT_EQ(grounding.name(Concept::kColor, pot[index(Concept::kColor)]), "red");
}

TEST(Model, ReadsManyPicturesAsEachAlone) {
  Renderer renderer;
  World other = cupAndPot();
  other.objects.pop_back();
  const std::vector<RgbdImage> images{renderer.render(cupAndPot(), {11, {}}),
                                      renderer.render(other, {12, {}})};
  const auto percepts = shippedModel().perceive(images);
  ASSERT_EQ(percepts.size(), 2U);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Percept alone = shippedModel().perceive(images[i]);
    EXPECT_EQ(percepts[i].instances, alone.instances);
    EXPECT_EQ(percepts[i].fits, alone.fits);
    for (std::size_t k = 0; k < alone.tokens.size(); ++k)
      EXPECT_TRUE(percepts[i].tokens[k].isApprox(alone.tokens[k], 1e-4F));
  }
}

/// By how many quarter turns instance 1 is read as turned.
int turnsOf(const Percept& initial, const Percept& goal) {
  const auto rotation = [](const Percept& percept) {
    const Symbols symbols = mostProbable(percept.beliefs[percept.position(1)]);
    const std::size_t k = index(Concept::kRotation);
    return static_cast<int>(shippedModel().symbols().values[k][index(symbols[k])]);
  };
  return (rotation(goal) - rotation(initial) + 4) % 4;
}

/// Half a turn of objects like none that was learned, each dyed and moved as well.
TEST(ReadTask, MeasuresHowUnlearnedObjectsAreTurned) {
  Renderer renderer;
  int tasks = 0, right = 0, right_alone = 0, turned_round = 0;
  for (const ObjectType type : {ObjectType::kCellphone, ObjectType::kPotato})
    for (int rotation = 0; rotation < 4; ++rotation)
      for (int color = 0; color < 3; ++color) {
        World before, after;
        before.objects = {{type, {0, 1}, rotation, color, 3}};
        after.objects = {{type, {2, 2}, (rotation + 2) % 4, color + 3, 3}};
        const RgbdImage initial = renderer.render(before, {5, {}});
        const RgbdImage goal = renderer.render(after, {5, {}});
        const Percept alone[] = {shippedModel().perceive(initial), shippedModel().perceive(goal)};
        const TaskReading read = shippedModel().readTask(initial, goal);
        EXPECT_EQ(read.initial.beliefs, alone[0].beliefs);
        ++tasks;
        right += turnsOf(read.initial, read.goal) == 2 ? 1 : 0;
        right_alone += turnsOf(alone[0], alone[1]) == 2 ? 1 : 0;
        turned_round += read.turned_round.front() ? 1 : 0;
        EXPECT_EQ(read.turned_round.front(), read.goal.beliefs != alone[1].beliefs);
      }
  EXPECT_GE(right, tasks - 2);
  EXPECT_GT(right, right_alone);
  EXPECT_GT(turned_round, 0);
}

TEST(ReadTask, ReadsLearnedObjectsAsEachPictureAlone) {
  Renderer renderer;
  World after = cupAndPot();
  after.objects[0].rotation = 3;
  const RgbdImage initial = renderer.render(cupAndPot(), {11, {}});
  const RgbdImage goal = renderer.render(after, {11, {}});
  const TaskReading read = shippedModel().readTask(initial, goal);
  EXPECT_EQ(read.initial.beliefs, shippedModel().perceive(initial).beliefs);
  EXPECT_EQ(read.goal.beliefs, shippedModel().perceive(goal).beliefs);
  EXPECT_EQ(read.turned_round, std::vector<bool>(2, false));
  EXPECT_EQ(read.goal_recognised, shippedModel().recognises(goal, read.goal));
}

TEST(ReadTask, RefusesAPictureOfAnotherSize) {
  RgbdImage small;
  small.width = small.height = 64;
  Renderer renderer;
  EXPECT_THAT(
      [&] {
        shippedModel().readTask(renderer.render(cupAndPot(), {11, {}}), small);
      },
      testing::ThrowsMessage<std::invalid_argument>(
          testing::HasSubstr("a picture of 64 x 64, expected 384 x 256")));
}

TEST(Model, DrawsEveryStepOfAPlan) {
  Renderer renderer;
  const RgbdImage image = renderer.render(cupAndPot(), {11, {}});
  const Percept percept = shippedModel().perceive(image);
  Plan plan;
  plan.actions = {Action::kMoveRight};
  Symbols after = mostProbable(percept.beliefs[0]);
  const auto& columns = shippedModel().symbolic().grounding.columns;
  after[index(Concept::kPositionX)] = SymbolId{
      static_cast<std::int32_t>(std::find(columns.begin(), columns.end(), 1) - columns.begin())};
  plan.predicted = {after};
  const auto frames = shippedModel().render(image, percept, 1, plan);
  ASSERT_EQ(frames.size(), 1U);
  World moved = cupAndPot();
  moved.objects[0].cell.x = 1;
  const RgbdImage truth = renderer.render(moved, {11, {}});
  const auto error = [&](const std::vector<std::uint8_t>& rgb) {
    double sum = 0;
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      const double d = static_cast<double>(rgb[i]) - truth.rgb[i];
      sum += d * d;
    }
    return sum;
  };
  // Much nearer to what the simulator shows than the picture before the step.
  EXPECT_LT(error(frames[0].rgb), 0.5 * error(image.rgb));
  EXPECT_THROW(shippedModel().render(image, percept, 9, plan), std::invalid_argument);
}

TEST(Model, DrawsManyPlansAsEachAlone) {
  Renderer renderer;
  const RgbdImage image = renderer.render(cupAndPot(), {11, {}});
  const Percept percept = shippedModel().perceive(image);
  const Symbols cup = mostProbable(percept.beliefs[0]), pot = mostProbable(percept.beliefs[1]);
  Plan both;  // three turns
  both.actions = {Action::kRotateLeft, Action::kMoveFront, Action::kMoveFront, Action::kRotateLeft};
  both.predicted = {cup, pot, pot, cup};
  both.moved = {0, 1, 1, 0};
  Plan one;
  one.actions = {Action::kRotateLeft};
  one.predicted = {pot};
  const Plan none;
  const std::vector<RenderQuery> queries{
      {image, percept, 1, both}, {image, percept, 2, one}, {image, percept, 1, none}};
  const auto drawn = shippedModel().render(queries);
  ASSERT_EQ(drawn.size(), queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const RenderQuery& query = queries[i];
    const auto alone = shippedModel().render(image, percept, query.target, query.plan);
    ASSERT_EQ(drawn[i].size(), query.plan.actions.size());
    ASSERT_EQ(alone.size(), drawn[i].size());
    for (std::size_t step = 0; step < alone.size(); ++step) {
      // Other numbers of pictures at once are summed up in another order.
      for (std::size_t k = 0; k < alone[step].rgb.size(); ++k)
        ASSERT_NEAR(drawn[i][step].rgb[k], alone[step].rgb[k], 1) << i << ", " << step;
      EXPECT_EQ(drawn[i][step].mask, alone[step].mask) << i << ", " << step;
    }
  }
  EXPECT_NE(drawn[0][0].mask, image.mask);
}

TEST(Model, RefusesAFolderWithAFlippedByte) {
  const TemporaryFolder folder;
  std::filesystem::copy(CONCEPTPLAN_SHIPPED_MODEL, folder.path(),
                        std::filesystem::copy_options::recursive);
  std::string bytes = readFile(folder.path() / kVictFile);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  writeFileAtomically(folder.path() / kVictFile, bytes);
  EXPECT_THAT([&] { Model{folder.path()}; },
              testing::ThrowsMessage<InputError>(testing::AllOf(
                  testing::HasSubstr("vict.safetensors"), testing::HasSubstr("damaged"))));
}

TEST(FindModel, NamesThePlacesItLookedIn) {
  EXPECT_EQ(findModel(CONCEPTPLAN_SHIPPED_MODEL), CONCEPTPLAN_SHIPPED_MODEL);
  EXPECT_TRUE(std::filesystem::exists(findModel("default") / "manifest.json"));
  EXPECT_THAT([] { findModel("nowhere"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("nowhere")));
}

}  // namespace
}  // namespace conceptplan
