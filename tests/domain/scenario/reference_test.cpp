#include "conceptplan/domain/scenario/reference.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "domain/scenario/sample_scenario.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;

TEST(Reference, RoundTrip) {
  const TemporaryFolder folder;
  const Reference written = sampleReference();
  writeReference(folder / "reference.yaml", written);
  const Reference read = readReference(folder / "reference.yaml");
  EXPECT_EQ(read.task.id, written.task.id);
  EXPECT_EQ(read.task.level, written.task.level);
  EXPECT_EQ(read.task.initial, written.task.initial);
  EXPECT_EQ(read.task.goal, written.task.goal);
  EXPECT_EQ(read.task.reference, written.task.reference);
  EXPECT_EQ(read.task.appearance, written.task.appearance);
  EXPECT_EQ(read.domain, written.domain);
}

TEST(Reference, AnEmptyPlanSolvesOnlyWhatIsSolved) {
  Reference reference = sampleReference();
  EXPECT_TRUE(hasSolution(reference));
  reference.task.reference.clear();
  EXPECT_FALSE(hasSolution(reference));
  reference.task.goal = reference.task.initial.objects[reference.task.initial.target];
  EXPECT_TRUE(hasSolution(reference));
}

TEST(Reference, AllFaultsComeTogetherWithTheirPlaces) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("reference.yaml",
                   "conceptplan: 1\n"
                   "id: bad\n"
                   "level: 5\n"
                   "domain: moon\n"
                   "appearance: -1\n"
                   "workbench: {columns: 3, rows: 5, cell_m: 0.2}\n"
                   "objects:\n"
                   "  - {type: Cupp, cell: [0, 0], rotation: 0, color: red, size: 0}\n"
                   "  - {type: Cup, cell: [9, 0], rotation: 4, color: rad, size: 0}\n"
                   "  - {type: Pot, cell: [0, 0], rotation: 0, color: red, size: 0}\n"
                   "target: 7\n"
                   "goal: {type: Cup, rotation: 0, color: red, size: 0}\n"
                   "plan: [move_frnt]\n");
  const std::string faults = faultsOf([&] { readReference(path); });
  const std::string file = path.string();
  EXPECT_THAT(faults, HasSubstr(file + ":3:8: level: expected a whole number in [1, 4]"));
  EXPECT_THAT(faults, HasSubstr(":4:9: domain: expected standard or shifted, found \"moon\""));
  EXPECT_THAT(faults, HasSubstr(":5:13: appearance: expected a seed"));
  EXPECT_THAT(faults, HasSubstr(":8:12: objects[0].type: unknown type \"Cupp\"; did you mean "
                                "\"Cup\"?"));
  EXPECT_THAT(faults, HasSubstr("objects[1].cell: expected [column, row] on the workbench"));
  EXPECT_THAT(faults, HasSubstr("objects[1].rotation: expected a whole number in [0, 3]"));
  EXPECT_THAT(faults, HasSubstr("objects[1].color: unknown colour \"rad\"; did you mean \"red\"?"));
  EXPECT_THAT(faults, HasSubstr("objects[2].cell: another object stands in that cell"));
  EXPECT_THAT(faults, HasSubstr("target: expected a whole number in [1, 3], found \"7\""));
  EXPECT_THAT(faults, HasSubstr(":12:7: goal.cell: the key is missing"));
  EXPECT_THAT(faults, HasSubstr("plan: unknown action \"move_frnt\"; did you mean "
                                "\"move_front\"?"));
}

Reference twoTargetReference() {
  Reference reference = sampleReference();
  reference.task.further = {{0, {ObjectType::kCup, {0, 3}, 1, 0, 2}}};
  reference.task.reference.push_back(Action::kMoveFront);
  reference.task.moved = {1, 1, 1, 1, 0};
  return reference;
}

TEST(Reference, RoundTripOfSeveralTargets) {
  const TemporaryFolder folder;
  const Reference written = twoTargetReference();
  writeReference(folder / "reference.yaml", written);
  const Reference read = readReference(folder / "reference.yaml");
  EXPECT_EQ(read.task.initial, written.task.initial);
  EXPECT_EQ(read.task.goal, written.task.goal);
  EXPECT_EQ(read.task.further, written.task.further);
  EXPECT_EQ(read.task.reference, written.task.reference);
  EXPECT_EQ(read.task.moved, written.task.moved);
}

TEST(Reference, FaultsOfSeveralTargetsAreNamed) {
  const TemporaryFolder folder;
  const auto path = folder / "reference.yaml";
  writeReference(path, twoTargetReference());
  const std::string text = readFile(path);
  const auto faults = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    folder.write("reference.yaml", changed);
    return faultsOf([&] { readReference(path); });
  };
  EXPECT_THAT(faults("targets: [2, 1]", "targets: [2, 4]"),
              HasSubstr("targets: expected an object in [1, 3], found \"4\""));
  EXPECT_THAT(faults("targets: [2, 1]", "targets: [2]"),
              HasSubstr("goals: expected a list of a goal for each of `targets`"));
  EXPECT_THAT(faults("moved: [2, 2, 2, 2, 1]", "moved: [2, 1]"),
              HasSubstr("moved: expected an object for each of 5 actions, found 2"));
  EXPECT_THAT(faults("moved:", "target: 1\nmoved:"), HasSubstr("target: is for one target"));
  EXPECT_THAT(faults("targets: [2, 1]", "target: 2"), HasSubstr("goals: is for several targets"));
}

}  // namespace
}  // namespace conceptplan
