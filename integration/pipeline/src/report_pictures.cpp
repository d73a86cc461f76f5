#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "conceptplan/domain/image_quality.hpp"
#include "report_markup.hpp"
#include "report_outline.hpp"
#include "report_sections.hpp"
#include "report_symbols.hpp"

namespace conceptplan::report {
namespace {

// Told apart by most people who see colours differently; after Okabe and Ito.
constexpr std::array<const char*, 7> kOutlineColors{"#f0e442", "#56b4e9", "#e69f00", "#00c795",
                                                    "#ff8fc7", "#d8d8d8", "#ff7f50"};

std::string picture(const RgbdImage& image, const std::string& alternative) {
  return "<img src=\"" + dataUri(image.width, image.height, image.rgb) + "\" width=\"" +
         std::to_string(image.width) + "\" height=\"" + std::to_string(image.height) + "\" alt=\"" +
         alternative + "\">";
}

std::string outlineLayer(const Report& report, const RgbdImage& image) {
  std::string svg = "<svg class=\"outline\" viewBox=\"0 0 " + std::to_string(image.width) + " " +
                    std::to_string(image.height) + "\" aria-hidden=\"true\" focusable=\"false\">";
  std::string labels;
  const std::size_t count = report.problem.initial.objects.size();
  for (const Outline& outline : outlines(image)) {
    std::size_t object = 0;
    while (object < count && instance(report, object) != outline.instance) ++object;
    svg += std::string("<g") + (isTarget(report, object) ? " class=\"target\"" : "") +
           "><path class=\"under\" d=\"" + outline.path + "\"/><path class=\"over\" stroke=\"" +
           kOutlineColors[outline.instance % kOutlineColors.size()] + "\" d=\"" + outline.path +
           "\"/></g>";
    const std::string label =
        object < count ? objectName(report, object) : std::to_string(outline.instance);
    labels += "<text x=\"" + decimal(outline.center_x, 1) + "\" y=\"" +
              decimal(std::max(outline.top - 4, 9.0), 1) + "\">" + label + "</text>";
  }
  return svg + labels + "</svg>";
}

std::string shown(const Report& report, const RgbdImage& image, const std::string& caption,
                  const std::string& alternative) {
  std::string html = "<figure class=\"card\"><div class=\"frame\">" + picture(image, alternative);
  if (!image.mask.empty()) html += outlineLayer(report, image);
  return html + "</div><figcaption>" + caption + "</figcaption></figure>";
}

std::string framesOf(const ReportFrames& frames, const std::string& step) {
  std::string html;
  const auto add = [&](const RgbdImage& image, const std::string& caption,
                       const std::string& note) {
    if (image.width == 0) return;
    html += "<figure><div class=\"frame\">" + picture(image, caption + " after step " + step) +
            "</div><figcaption>" + caption + note + "</figcaption></figure>";
  };
  std::string match;
  if (frames.predicted.width > 0 && frames.predicted.rgb.size() == frames.reference.rgb.size() &&
      frames.predicted.width == frames.reference.width) {
    match = "<span class=\"match\">" +
            decimal(peakSignalToNoise_dB(frames.predicted, frames.reference), 1) +
            "&nbsp;dB</span>";
  }
  add(frames.predicted, "Predicted", match);
  add(frames.reference, "Simulated", "");
  return html.empty() ? html : "<div class=\"frames\">" + html + "</div>";
}

// "row 2 → row 3": what the action changes of the symbols.
std::string changes(const Report& report, const Symbols& before, const Symbols& after) {
  std::string text;
  for (const Concept which : kConcepts) {
    const SymbolId from = before[index(which)];
    const SymbolId to = after[index(which)];
    if (from == to) continue;
    if (!text.empty()) text += ", ";
    text += symbolName(report, which, from) + " → " + colorKey(report, which, to) +
            symbolName(report, which, to);
  }
  return text.empty() ? "nothing changes" : text;
}

std::string stepList(const Report& report, const Plan& plan) {
  std::string html;
  std::vector<Symbols> scene;
  for (const SymbolBelief& belief : report.problem.initial.objects) {
    scene.push_back(mostProbable(belief));
  }
  for (std::size_t i = 0; i < plan.actions.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    Symbols& before = scene[movedObject(report, plan, i)];
    html += "<li class=\"card\">";
    if (!report.frames.empty()) html += framesOf(report.frames[i], number);
    html += "<div class=\"what\"><h3><span class=\"number\">" + number + "</span>" +
            icon(plan.actions[i]) + movedName(report, plan, i) + words(plan.actions[i]) +
            "</h3><span class=\"change\">" + changes(report, before, plan.predicted[i]) +
            "</span></div></li>";
    before = plan.predicted[i];
  }
  return html;
}

bool comparesFrames(const Report& report) {
  return std::any_of(report.frames.begin(), report.frames.end(), [](const ReportFrames& frames) {
    return frames.predicted.width > 0 && frames.reference.width > 0;
  });
}

std::string motionCaption(const Report& report) {
  if (!report.motion) return "";
  const auto millimetres = [](double length_m) { return decimal(1000 * length_m, 0) + " mm"; };
  const ReportMotion& motion = *report.motion;
  const std::string measures = millimetres(motion.length_m) + " long and at least " +
                               millimetres(motion.clearance_m) + " clear of everything";
  if (motion.fallback.empty()) {
    return " The line is the refined motion, dotted where the target is lifted: " + measures + ".";
  }
  return " The line is the plan as it is, " + measures +
         ", since no refined motion does what is asked: " + escaped(motion.fallback) + ".";
}

std::string failureCaption(const Report& report) {
  return std::string(report.result.blocking.empty() ? ""
                                                    : ", what is in the way has a thick edge") +
         (report.result.nearest.empty() ? "."
                                        : ", the cross is the nearest to the goal that is in "
                                          "reach.");
}

}  // namespace

std::string picturesSection(const Report& report) {
  if (report.initial.width == 0 && report.goal.width == 0) return {};
  std::string html =
      "<section class=\"pictures\"><h2>The task</h2>"
      "<p class=\"note\">The workbench as it is, and as it should be. Each instance mask is "
      "outlined, the target's boldly, and labelled with the type that was read from it.</p>"
      "<label class=\"switch\"><input type=\"checkbox\" checked> Outlines</label>"
      "<div class=\"pair\">";
  if (report.initial.width > 0) {
    html += shown(report, report.initial, "<strong>Initial</strong>", "The workbench as it is");
  }
  if (report.goal.width > 0) {
    html += shown(report, report.goal, "<strong>Goal</strong>", "The workbench as it should be");
  }
  return html + "</div></section>";
}

std::string planSection(const Report& report) {
  const auto& plans = report.result.plans;
  std::string html = "<section><h2>The plan</h2><p class=\"note\">";
  if (plans.empty()) {
    html += "There is none.";
  } else if (plans.front().actions.empty()) {
    html += "Nothing needs to be done: the goal is reached at the start.";
  } else if (comparesFrames(report)) {
    html +=
        "Each step as the learned model predicts it, beside what the simulator shows. The figure "
        "in dB is the peak signal-to-noise ratio of the two pictures: higher is closer.";
  } else {
    html += "The most probable sequence of actions, step by step.";
  }
  html += "</p><div class=\"plan mapped\">";
  if (plans.empty()) {
    html += failureCard(report);
  } else if (plans.front().actions.empty()) {
    html += "<div></div>";
  } else {
    html += "<ol class=\"steps\" style=\"--step-width:" +
            std::string(comparesFrames(report) ? "21rem" : "12rem") + "\">" +
            stepList(report, plans.front()) + "</ol>";
  }
  return html + "<figure class=\"map card\">" + workbenchMap(report) + "<figcaption>From above: " +
         (report.targets.empty() ? "the target is round, the dashed cell is its goal"
                                 : "targets are round, dashed cells are their goals") +
         (plans.empty() ? failureCaption(report) : ", numbers are the steps.") +
         motionCaption(report) + "</figcaption></figure></div></section>";
}

}  // namespace conceptplan::report
