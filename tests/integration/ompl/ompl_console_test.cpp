#include "ompl_console.hpp"

#include <gmock/gmock.h>
#include <ompl/util/Console.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "conceptplan/ompl/ompl_planner.hpp"
#include "integration/ompl/task_graph.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A handler of the program.
class Recorder final : public ompl::msg::OutputHandler {
 public:
  void log(const std::string& text, ompl::msg::LogLevel, const char*, int) override {
    texts.push_back(text);
  }

  std::vector<std::string> texts;
};

void sayElsewhere(const char* text) {
  std::thread([&] { OMPL_WARN("%s", text); }).join();
}

/// The program's handler is `host_`, and was `before_`.
class OmplConsole : public ::testing::Test {
 protected:
  void SetUp() override {
    ompl::msg::useOutputHandler(&before_);
    ompl::msg::useOutputHandler(host_.get());
  }
  void TearDown() override {
    ompl::msg::useOutputHandler(standard_);
    ompl::msg::useOutputHandler(standard_);
  }

  ompl::msg::OutputHandler* const standard_ = ompl::msg::getOutputHandler();
  Recorder before_;
  std::unique_ptr<Recorder> host_ = std::make_unique<Recorder>();
};

TEST_F(OmplConsole, ThisThreadIsSilentAndOthersAreHeardByTheProgram) {
  {
    const OmplSilence silence;
    OMPL_WARN("silenced");
    sayElsewhere("heard");
    {
      const OmplSilence inner;
      OMPL_WARN("silenced");
    }
    OMPL_WARN("silenced");
  }
  OMPL_WARN("heard again");
  EXPECT_THAT(host_->texts, ElementsAre("heard", "heard again"));
  EXPECT_THAT(before_.texts, IsEmpty());
}

TEST_F(OmplConsole, ASilenceOfAnotherThreadEndsNoneOfThisThread) {
  auto silence = std::make_unique<OmplSilence>();
  std::thread([] {
    const OmplSilence other;
    OMPL_WARN("silenced");
  }).join();
  OMPL_WARN("silenced");
  EXPECT_NE(ompl::msg::getOutputHandler(), host_.get());
  silence.reset();
  EXPECT_EQ(ompl::msg::getOutputHandler(), host_.get());
  EXPECT_THAT(host_->texts, IsEmpty());
}

TEST_F(OmplConsole, AfterASolveTheProgramMayRestoreItsPreviousHandlerAndEndItsOwn) {
  PlannerRegistry registry;
  addOmplPlanners(registry);
  const auto graph = testing::graphOf(testing::testTask(1, 0));
  const ompl::msg::LogLevel level = ompl::msg::getLogLevel();
  EXPECT_EQ(registry.make("ompl-rrt")->solve(*graph, {}).status, PlanStatus::kSolved);
  EXPECT_EQ(ompl::msg::getOutputHandler(), host_.get());
  EXPECT_EQ(ompl::msg::getLogLevel(), level);
  ompl::msg::restorePreviousOutputHandler();
  ASSERT_EQ(ompl::msg::getOutputHandler(), &before_);
  host_.reset();
  OMPL_WARN("heard");
  EXPECT_THAT(before_.texts, ElementsAre("heard"));
}

TEST_F(OmplConsole, AHandlerThatIsSetDuringASilenceStays) {
  Recorder other;
  {
    const OmplSilence silence;
    ompl::msg::useOutputHandler(&other);
  }
  EXPECT_EQ(ompl::msg::getOutputHandler(), &other);
  {
    const OmplSilence silence;
    OMPL_WARN("silenced");
    sayElsewhere("by the other");
  }
  EXPECT_THAT(other.texts, ElementsAre("by the other"));
  ompl::msg::restorePreviousOutputHandler();
  OMPL_WARN("by the first");
  EXPECT_THAT(host_->texts, ElementsAre("by the first"));
}

TEST_F(OmplConsole, NoHandlerIsNoneAgain) {
  ompl::msg::noOutputHandler();
  {
    const OmplSilence silence;
    sayElsewhere("heard by none");
  }
  EXPECT_EQ(ompl::msg::getOutputHandler(), nullptr);
}

}  // namespace
}  // namespace conceptplan
