#include "conceptplan/pipeline/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "integration/report/sample_report.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t times = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++times;
  }
  return times;
}

std::string whatIsThrownFor(const Report& report) {
  try {
    renderReport(report);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

// A folder of this process that vanishes with the test.
class ReportFile : public ::testing::Test {
 protected:
  ReportFile() { std::filesystem::create_directories(folder_); }
  ~ReportFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("conceptplan-report-" + std::to_string(::getpid()));
};

TEST(Report, HoldsEveryPicture) {
  const Report report = sampleReport();
  EXPECT_EQ(count(renderReport(report), "<img src=\"data:image/png;base64,"),
            2 + 2 * report.frames.size());
}

TEST(Report, TellsWhichSymbolsAreGuesses) {
  EXPECT_THAT(renderReport(sampleReport()), HasSubstr("like none that was learned"));
}

TEST(Report, LoadsNothingFromANetwork) {
  const std::string page = renderReport(sampleReport());
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"[^d#]")));
}

TEST(Report, FillsTheWholeTemplate) {
  EXPECT_THAT(renderReport(sampleReport()), Not(HasSubstr("{{")));
}

TEST(Report, EscapesWhatItIsTold) {
  Report report = sampleReport();
  const std::string evil = "<b>\"&'</b>{{title}}";
  report.title = evil;
  report.verdict = evil;
  report.result.reason = evil;
  report.facts = {{evil, evil}};
  report.versions = {{evil, evil}};
  report.times_ms = {{evil, 1.0}};
  for (auto& names : report.grounding.names) names.assign(names.size(), evil);
  const std::string page = renderReport(report);
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
  EXPECT_GT(count(page, "&lt;b&gt;&quot;&amp;&#39;&lt;/b&gt;{{title}}"), 10U);
}

TEST(Report, TellsConfidenceAndTheSecondGuess) {
  Report report = sampleReport();
  report.problem.initial.objects[0][index(Concept::kRotation)] = {0.55, 0.45, 0, 0};
  const std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("55.0&nbsp;%"));
  EXPECT_THAT(page, HasSubstr("or 90 degrees 45.0&nbsp;%"));
}

TEST(Report, GroupsRejectionsByReason) {
  const std::string page = renderReport(sampleReport());
  EXPECT_EQ(count(page, "<article"), 3U);
  EXPECT_THAT(page, HasSubstr("Collision with Pot 2</h3><p>3 steps would bring the target "
                              "40&nbsp;mm deep into it."));
  EXPECT_THAT(page, HasSubstr("change color is not legal</h3><p>3 steps"));
  EXPECT_THAT(page, HasSubstr("in 0.2&nbsp;% of the cases at most; more than 1.0&nbsp;% are "));
  EXPECT_THAT(page, HasSubstr("Beyond the workbench</h3><p>1 step would bring part of the target "
                              "over the edge, by 20&nbsp;mm."));
}

TEST(Report, ShowsATaskWithoutPicturesOrPlan) {
  Report report = sampleReport();
  report.initial = report.goal = {};
  report.frames.clear();
  report.result.plans.clear();
  report.result.status = PlanStatus::kInfeasible;
  report.result.reason = "No sequence of at most 24 actions reaches the goal.";
  const std::string page = renderReport(report);
  EXPECT_EQ(count(page, "<img"), 0U);
  EXPECT_THAT(page, HasSubstr("infeasible"));
  EXPECT_THAT(page, HasSubstr("No sequence of at most 24 actions reaches the goal."));
}

TEST(Report, TellsEveryStepThatWasRuledOut) {
  Report report = sampleReport();
  report.result.rejections[0].value = -0.0312;
  EXPECT_THAT(renderReport(report), HasSubstr("the target 31 to 40&nbsp;mm deep into it."));
  report.result.rejections[2].value = 0.0005;
  const std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("the target up to 40&nbsp;mm deep into it."));
  EXPECT_THAT(page, HasSubstr("<summary>Every step (7)</summary>"));
  EXPECT_THAT(page,
              HasSubstr("<td>collision with Pot 2</td><td class=\"n\">31.2&nbsp;mm deep</td>"));
  EXPECT_THAT(page,
              HasSubstr("<td>collision with Pot 2</td><td class=\"n\">0.5&nbsp;mm away</td>"));
  EXPECT_THAT(page, HasSubstr("<td>edge of the workbench</td>"));
  EXPECT_THAT(page, HasSubstr("<td>action threshold</td><td class=\"n\">0.1&nbsp;%</td>"));
}

TEST(Report, SaysWhatIsInTheWayAndHowNearTheTargetGets) {
  Report report = sampleReport();
  report.frames.clear();
  report.result.plans.clear();
  report.result.status = PlanStatus::kInfeasible;
  report.result.reason = "no way";
  std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("<p>No way.</p>"));
  report.result.reason = "COLOR and POSITION_Y must change";
  EXPECT_THAT(renderReport(report), HasSubstr("<p>Color and row must change.</p>"));
  EXPECT_THAT(page, HasSubstr("3 by the action threshold, 3 by collision and 1 by the edge"));
  report.instances = {4, 5, 9};
  report.result.blocking = {1, 2};
  report.result.nearest = {mostProbable(report.problem.goal)};
  report.result.nearest[0][index(Concept::kColor)] = SymbolId{0};
  page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("Without <strong>Pot 5</strong> and <strong>Dyer 9</strong> there"));
  EXPECT_THAT(page, HasSubstr("in reach has red in place of <strong>blue</strong>."));
  EXPECT_THAT(page, HasSubstr("Nearest in reach"));
  EXPECT_EQ(count(page, "class=\"thing blocking\""), 2U);
  EXPECT_EQ(count(page, "class=\"nearest\""), 1U);
  report.result.blocking = {3};
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("object 3 of 3 is said to be in the way"));
}

TEST(Report, TellsWhatWasRuledOutOverTheWholeSearch) {
  Report report = sampleReport();
  EXPECT_THAT(renderReport(report), Not(HasSubstr("that the search expanded")));
  report.result.rejections.clear();
  report.result.ruled_out = RejectionTally{12,
                                           {{Invalidity::kNone, std::nullopt, 31, 0, 0.005},
                                            {Invalidity::kCollision, 1, 7, -0.04, -0.02},
                                            {Invalidity::kWorkbenchEdge, std::nullopt, 3, 0, 0}}};
  const std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("Over all 12 states that the search expanded:"));
  EXPECT_THAT(page, HasSubstr("<td>action threshold</td><td class=\"n\">31</td>"
                              "<td class=\"n\">0.5&nbsp;% at most</td>"));
  EXPECT_THAT(page, HasSubstr("<td>collision with Pot 2</td><td class=\"n\">7</td>"
                              "<td class=\"n\">20 to 40&nbsp;mm deep</td>"));
  EXPECT_THAT(page, HasSubstr("<td>edge of the workbench</td><td class=\"n\">3</td>"
                              "<td class=\"n\"></td>"));
  report.result.ruled_out->counts[1].object = 3;
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("a rejection names object 3 of 3"));
}

TEST(Report, TellsOfEachOfSeveralTargetsHowNearItGets) {
  Report report = sampleReport();
  report.frames.clear();
  report.result.plans.clear();
  report.result.status = PlanStatus::kInfeasible;
  report.targets = {{0, report.problem.goal}, {1, report.problem.initial.objects[1]}};
  report.result.nearest = {mostProbable(report.problem.goal),
                           mostProbable(report.problem.initial.objects[1])};
  report.result.nearest[1][index(Concept::kColor)] = SymbolId{0};
  report.result.blocking = {2};
  report.result.rejections.back().moved = 1;
  const std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("Pot 2: The nearest to the goal that is in reach has red in place"));
  EXPECT_THAT(page, HasSubstr("Pot 2: Nearest in reach"));
  EXPECT_THAT(page, HasSubstr("there would be a way for each target, were the others not there"));
  EXPECT_THAT(page, HasSubstr("<tr><td>Pot 2: "));
  EXPECT_EQ(count(page, "class=\"nearest\""), 2U);
  report.result.nearest.pop_back();
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("the nearest symbols of 1 targets of 2"));
}

TEST(Report, CallsObjectsOfAnUnnamedTypeByTheirIdAlone) {
  Report report = sampleReport();
  report.instances = {4, 5, 9};
  report.grounding.names[index(Concept::kType)].clear();
  EXPECT_THAT(renderReport(report), HasSubstr("Collision with object 5"));
}

TEST(Report, SaysThatNothingNeedsToBeDone) {
  Report report = sampleReport();
  report.frames.clear();
  report.result.plans = {Plan{{}, 0.9, 0.1, {}}};
  EXPECT_THAT(renderReport(report), HasSubstr("Nothing needs to be done"));
}

TEST(Report, DrawsTheRefinedMotionOverTheMap) {
  Report report = sampleReport();
  EXPECT_THAT(renderReport(report), Not(HasSubstr("class=\"motion")));
  report.motion =
      ReportMotion{{{-0.2, -0.2, 0}, {-0.1, 0, 0}, {0, 0.1, 0.1}, {0, 0.2, 0}}, 0.4321, 0.0126, ""};
  const std::string page = renderReport(report);
  // The middle of the workbench of 3 x 5 cells of 64 lies at 96, 18 + 160.
  EXPECT_THAT(page, HasSubstr("class=\"motion\" d=\"M32.0 242.0L64.0 178.0\""));
  EXPECT_THAT(page, HasSubstr("class=\"motion lifted\" d=\"M64.0 178.0L96.0 146.0\""));
  EXPECT_THAT(page, HasSubstr("432 mm long and at least 13 mm clear"));
  report.motion->fallback = "the start is <too> near";
  EXPECT_THAT(renderReport(report), HasSubstr("the start is &lt;too&gt; near"));
}

TEST(Report, NamesObjectsByTheirMask) {
  Report report = sampleReport();
  report.instances = {7, 8, 9};
  const std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("Cup 7"));
  EXPECT_THAT(page, HasSubstr("Collision with Pot 8"));
}

TEST(Report, EqualReportsGiveEqualPages) {
  EXPECT_EQ(renderReport(sampleReport()), renderReport(sampleReport()));
}

TEST(Report, RefusesWhatDoesNotFit) {
  Report report = sampleReport();
  report.problem.initial.target = 3;
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("the target is object 3 of 3"));
  report = sampleReport();
  report.frames.pop_back();
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("6 predicted states and 5 pairs of frames"));
  report = sampleReport();
  report.goal.rgb.pop_back();
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("goal picture of 384 x 256 has 294911 bytes"));
  report = sampleReport();
  report.result.rejections[0].object = 5;
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("a rejection names object 5 of 3"));
  report = sampleReport();
  report.instances = {1};
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("1 mask ids for 3 objects"));
}

TEST_F(ReportFile, IsWrittenWhole) {
  const auto path = folder_ / "report.html";
  writeReport(path, sampleReport());
  EXPECT_EQ(readFile(path), renderReport(sampleReport()));
}

#ifdef CONCEPTPLAN_CHROMIUM
TEST_F(ReportFile, OpensInABrowserWithEveryPictureLoaded) {
  const Report report = sampleReport();
  std::string page = renderReport(report);
  // Waits for all pictures, then leaves what it found in the document's attributes.
  const std::string script =
      "<script>addEventListener('load',()=>{const r=document.documentElement,"
      "i=[...document.images];r.dataset.loaded=i.filter(p=>p.complete&&p.naturalWidth>0).length+"
      "' of '+i.length;r.dataset.fits=r.scrollWidth<=innerWidth;"
      "r.dataset.requests=performance.getEntriesByType('resource')"
      ".filter(e=>!e.name.startsWith('data:')).length})</script>";
  page.insert(page.rfind("</body>"), script);
  writeFileAtomically(folder_ / "page.html", page);
  const std::string command =
      "timeout 90 " CONCEPTPLAN_CHROMIUM
      " --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
      " --disable-background-networking --disable-component-update --disable-sync"
      " --window-size=500,900 --user-data-dir='" +
      (folder_ / "profile").string() + "' --dump-dom 'file://" + (folder_ / "page.html").string() +
      "' > '" + (folder_ / "dom.html").string() + "' 2> /dev/null < /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  const std::string dom = readFile(folder_ / "dom.html");
  const std::string all = std::to_string(2 + 2 * report.frames.size());
  EXPECT_THAT(dom, HasSubstr("data-loaded=\"" + all + " of " + all + "\""));
  EXPECT_THAT(dom, HasSubstr("data-fits=\"true\""));
  EXPECT_THAT(dom, HasSubstr("data-requests=\"0\""));
}
#endif

TEST(Report, SaysWhichOfSeveralTargetsEachActionMoves) {
  Report report = sampleReport();
  report.frames.clear();
  report.targets = {{0, report.problem.goal}, {1, report.problem.initial.objects[1]}};
  report.targets[1].goal[index(Concept::kPositionX)] = {1, 0, 0};
  Plan plan = report.result.plans.front();
  plan.actions.push_back(Action::kMoveLeft);
  plan.predicted.push_back(mostProbable(report.targets[1].goal));
  plan.moved = {0, 0, 0, 0, 0, 0, 1};
  report.result.plans = {plan};
  const std::string page = renderReport(report);
  EXPECT_THAT(page, HasSubstr("Pot 2: move left</h3>"));
  EXPECT_THAT(page, HasSubstr("column 1 → column 0"));
  EXPECT_EQ(count(page, "class=\"goal-mark\""), 2U);
  EXPECT_EQ(count(page, "<span class=\"tag\">goal</span>"), 2U);
  EXPECT_THAT(page, HasSubstr("targets are round"));
  report.result.plans[0].moved.pop_back();
  EXPECT_THAT(whatIsThrownFor(report), HasSubstr("7 actions for 2 targets moves 6 times"));
}

}  // namespace
}  // namespace conceptplan
