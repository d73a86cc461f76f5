#include "conceptplan/pipeline/report.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "report_markup.hpp"
#include "report_sections.hpp"

namespace conceptplan {
namespace report {

extern const std::string_view kPage;  // report_page.html

}  // namespace report

namespace {

void checkPicture(const std::string& what, const RgbdImage& image) {
  const auto pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.rgb.size() != 3 * pixels || (!image.mask.empty() && image.mask.size() != pixels)) {
    throw std::invalid_argument("report: " + what + " picture of " + std::to_string(image.width) +
                                " x " + std::to_string(image.height) + " has " +
                                std::to_string(image.rgb.size()) + " bytes of colour and " +
                                std::to_string(image.mask.size()) + " of mask");
  }
}

void check(const Report& report) {
  const SymbolicScene& scene = report.problem.initial;
  const std::size_t count = scene.objects.size();
  if (scene.target >= count) {
    throw std::invalid_argument("report: the target is object " + std::to_string(scene.target) +
                                " of " + std::to_string(count));
  }
  for (const TargetGoal& target : report.targets) {
    if (target.object >= count) {
      throw std::invalid_argument("report: a target is object " + std::to_string(target.object) +
                                  " of " + std::to_string(count));
    }
  }
  for (const Plan& plan : report.result.plans) {
    if (plan.moved.size() != (report.targets.empty() ? 0 : plan.actions.size()) ||
        std::ranges::any_of(plan.moved, [count](std::size_t moved) { return moved >= count; })) {
      throw std::invalid_argument("report: a plan of " + std::to_string(plan.actions.size()) +
                                  " actions for " + std::to_string(report.targets.size()) +
                                  " targets moves " + std::to_string(plan.moved.size()) +
                                  " times one of " + std::to_string(count) + " objects");
    }
  }
  if (!report.instances.empty() && report.instances.size() != count) {
    throw std::invalid_argument("report: " + std::to_string(report.instances.size()) +
                                " mask ids for " + std::to_string(count) + " objects");
  }
  const auto checkRejected = [count](std::optional<std::size_t> object) {
    if (object.value_or(0) < count) return;
    throw std::invalid_argument("report: a rejection names object " + std::to_string(*object) +
                                " of " + std::to_string(count));
  };
  for (const Rejection& rejection : report.result.rejections) {
    checkRejected(rejection.object);
    checkRejected(rejection.moved);
  }
  if (report.result.ruled_out) {
    for (const RejectionCount& ruled_out : report.result.ruled_out->counts) {
      checkRejected(ruled_out.object);
    }
  }
  const std::size_t near = report.result.nearest.size();
  if (near != 0 && near != std::max<std::size_t>(report.targets.size(), 1)) {
    throw std::invalid_argument("report: the nearest symbols of " + std::to_string(near) +
                                " targets of " + std::to_string(report.targets.size()));
  }
  for (const std::size_t object : report.result.blocking) {
    if (object >= count) {
      throw std::invalid_argument("report: object " + std::to_string(object) + " of " +
                                  std::to_string(count) + " is said to be in the way");
    }
  }
  if (!report.result.plans.empty()) {
    const Plan& best = report.result.plans.front();
    if (best.predicted.size() != best.actions.size() ||
        (!report.frames.empty() && report.frames.size() != best.actions.size())) {
      throw std::invalid_argument("report: the best plan has " +
                                  std::to_string(best.actions.size()) + " actions, " +
                                  std::to_string(best.predicted.size()) + " predicted states and " +
                                  std::to_string(report.frames.size()) + " pairs of frames");
    }
  }
  checkPicture("initial", report.initial);
  checkPicture("goal", report.goal);
  for (const ReportFrames& frames : report.frames) {
    checkPicture("predicted", frames.predicted);
    checkPicture("reference", frames.reference);
  }
}

}  // namespace

std::string renderReport(const Report& report) {
  check(report);
  return report::filled(report::kPage, {{"title", report::escaped(report.title)},
                                        {"summary", report::summarySection(report)},
                                        {"pictures", report::picturesSection(report)},
                                        {"plan", report::planSection(report)},
                                        {"alternatives", report::alternativesSection(report)},
                                        {"symbols", report::symbolsSection(report)},
                                        {"rejections", report::rejectionsSection(report)},
                                        {"facts", report::factsSection(report)}});
}

void writeReport(const std::filesystem::path& path, const Report& report) {
  writeFileAtomically(path, renderReport(report));
}

}  // namespace conceptplan
