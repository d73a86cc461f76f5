#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "report_markup.hpp"
#include "report_sections.hpp"
#include "report_symbols.hpp"

namespace conceptplan::report {
namespace {

constexpr int kCell = 64;    // edge of a cell of the map, in its own units
constexpr int kMargin = 18;  // above and below, for the captions of the sides

struct Point {
  double x = 0;
  double y = 0;
};

Point center(const Workbench& workbench, Cell cell) {
  return {kCell * (cell.x + 0.5), kMargin + kCell * (workbench.rows - 1 - cell.y + 0.5)};
}

std::string text(Point at, const std::string& content, bool quiet = false) {
  return "<text" + std::string(quiet ? " class=\"quiet\"" : "") + attribute("x", at.x) +
         attribute("y", at.y) + ">" + content + "</text>";
}

std::string cells(const Workbench& workbench, int edge, int margin) {
  std::string svg;
  for (int y = 0; y < workbench.rows; ++y) {
    for (int x = 0; x < workbench.columns; ++x) {
      svg += "<rect class=\"cell\"" + attribute("x", edge * x + 0.5) +
             attribute("y", margin + edge * y + 0.5) + attribute("width", edge) +
             attribute("height", edge) + "/>";
    }
  }
  return svg;
}

// The symbol's own colour if its name tells one. `kind` is a further class, or empty.
std::string fill(const Report& report, const SymbolBelief& belief, const std::string& kind) {
  const SymbolId color = mostProbable(belief)[index(Concept::kColor)];
  const std::string_view css = cssColor(symbolName(report, Concept::kColor, color));
  const std::string all = "thing" + (kind.empty() ? "" : " " + kind);
  return css.empty() ? " class=\"" + all + " plain\""
                     : " class=\"" + all + "\" fill=\"" + std::string(css) + "\"";
}

Cell initialCell(const Report& report, std::size_t object) {
  return report.grounding.cell(mostProbable(report.problem.initial.objects[object]));
}

std::string things(const Report& report) {
  std::string svg;
  const SymbolicScene& scene = report.problem.initial;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Point at = center(scene.workbench, initialCell(report, i));
    if (isTarget(report, i)) {
      svg += "<circle" + fill(report, scene.objects[i], "") + attribute("cx", at.x) +
             attribute("cy", at.y) + attribute("r", 17) + "/>";
    } else {
      const bool blocks = std::ranges::count(report.result.blocking, i) > 0;
      svg += "<rect" + fill(report, scene.objects[i], blocks ? "blocking" : "") +
             attribute("x", at.x - 19) + attribute("y", at.y - 19) + attribute("width", 38) +
             attribute("height", 38) + attribute("rx", 6) + "/>";
    }
  }
  return svg;
}

std::string thingNames(const Report& report) {
  std::string svg;
  for (std::size_t i = 0; i < report.problem.initial.objects.size(); ++i) {
    const Point at = center(report.problem.initial.workbench, initialCell(report, i));
    svg += text({at.x, at.y + 28}, objectName(report, i));
  }
  return svg;
}

// The moves as arrows, each drawn a little to the right of its way so that going there and coming
// back stay apart, and what is done within a cell as signs in its corner.
std::string way(const Report& report, const Plan& plan) {
  const Workbench& workbench = report.problem.initial.workbench;
  std::string svg;
  std::map<Cell, int> signs;
  std::map<std::size_t, Cell> last;  // of the objects that have moved
  for (std::size_t i = 0; i < plan.actions.size(); ++i) {
    const std::size_t moved = movedObject(report, plan, i);
    const bool first = !last.contains(moved);
    const Cell from = first ? initialCell(report, moved) : last[moved];
    const Cell to = report.grounding.cell(plan.predicted[i]);
    const std::string number = std::to_string(i + 1);
    const Point a = center(workbench, from);
    const Point b = center(workbench, to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length > 0) {
      const Point along{(b.x - a.x) / length, (b.y - a.y) / length};
      const Point right{-along.y, along.x};
      const auto place = [&](double forward, double sideways) {
        return Point{a.x + along.x * forward + right.x * sideways,
                     a.y + along.y * forward + right.y * sideways};
      };
      const auto line = [](Point at) { return decimal(at.x, 1) + " " + decimal(at.y, 1) + " "; };
      const double start = first ? 20 : 8;  // outside of the target's disc
      svg += "<path class=\"path\" d=\"M" + line(place(start, 5)) + "L" +
             line(place(length - 8, 5)) + "M" + line(place(length - 14, -1)) + "L" +
             line(place(length - 8, 5)) + "L" + line(place(length - 14, 11)) + "\"/>";
      const Point label = place(0.5 * length - 2, 13);
      svg += text({label.x, label.y + 3}, number);
    } else {
      const int sign = signs[to]++;
      const Point corner{b.x - 27 + 27 * (sign % 2), b.y - 27 + 14 * (sign / 2)};
      svg += "<svg class=\"icon\"" + attribute("x", corner.x + 9) + attribute("y", corner.y) +
             " width=\"12\" height=\"12\"><use href=\"#" + std::string(name(plan.actions[i])) +
             "\"/></svg>";
      svg += text({corner.x + 4, corner.y + 9}, number);
    }
    last[moved] = to;
  }
  return svg;
}

// A cross where each target is when they get nearest to their goals.
std::string nearestMarks(const Report& report) {
  const auto line = [](double x, double y) { return decimal(x, 1) + " " + decimal(y, 1); };
  std::string svg;
  for (const Symbols& nearest : report.result.nearest) {
    const Point at = center(report.problem.initial.workbench, report.grounding.cell(nearest));
    svg += "<path class=\"nearest\" d=\"M" + line(at.x - 9, at.y - 9) + "L" +
           line(at.x + 9, at.y + 9) + "M" + line(at.x + 9, at.y - 9) + "L" +
           line(at.x - 9, at.y + 9) + "\"/>";
  }
  return svg;
}

/// The refined motion, dotted where the target is lifted.
std::string motionPath(const Report& report, const ReportMotion& motion) {
  const Workbench& workbench = report.problem.initial.workbench;
  const auto place = [&](const Eigen::Vector3d& point) {
    return decimal(kCell * (point.x() / workbench.cell_m + 0.5 * workbench.columns), 1) + " " +
           decimal(kMargin + kCell * (0.5 * workbench.rows - point.y() / workbench.cell_m), 1);
  };
  const auto isLifted = [](const Eigen::Vector3d& point) { return point.z() > 0; };
  std::string svg;
  for (std::size_t first = 0; first + 1 < motion.points.size();) {
    const bool lifted = isLifted(motion.points[first + 1]);
    std::size_t last = first + 1;
    std::string line = "M" + place(motion.points[first]) + "L" + place(motion.points[last]);
    while (last + 1 < motion.points.size() && isLifted(motion.points[last + 1]) == lifted) {
      line += " " + place(motion.points[++last]);
    }
    svg +=
        "<path class=\"motion" + std::string(lifted ? " lifted" : "") + "\" d=\"" + line + "\"/>";
    first = last;
  }
  return svg;
}

}  // namespace

std::string workbenchMap(const Report& report) {
  const Workbench& bench = report.problem.initial.workbench;
  const int width = kCell * bench.columns + 1;
  const int height = kCell * bench.rows + 2 * kMargin + 1;
  std::string svg = "<svg viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(height) +
                    "\" role=\"img\" aria-label=\"Map of the workbench from above\">" +
                    cells(bench, kCell, kMargin);
  svg += text({0.5 * width, kMargin - 6.0}, "far side", true);
  svg += text({0.5 * width, height - 6.0}, "camera side", true);
  for (const TargetGoal& target : targetsOf(report)) {
    const Point goal = center(bench, report.grounding.cell(mostProbable(target.goal)));
    svg += "<rect class=\"goal-mark\"" + attribute("x", goal.x - 28) + attribute("y", goal.y - 28) +
           attribute("width", 56) + attribute("height", 56) + attribute("rx", 8) + "/>";
  }
  svg += things(report) + nearestMarks(report);
  if (report.motion) svg += motionPath(report, *report.motion);
  if (!report.result.plans.empty()) svg += way(report, report.result.plans.front());
  return svg + thingNames(report) + "</svg>";
}

std::string heatMap(const Workbench& workbench, const std::vector<std::size_t>& counts) {
  constexpr int kEdge = 20;
  const std::size_t most =
      std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  std::string svg = "<svg viewBox=\"0 0 " + std::to_string(kEdge * workbench.columns + 1) + " " +
                    std::to_string(kEdge * workbench.rows + 1) +
                    "\" aria-hidden=\"true\" focusable=\"false\">" + cells(workbench, kEdge, 0);
  for (int y = 0; y < workbench.rows; ++y) {
    for (int x = 0; x < workbench.columns; ++x) {
      const std::size_t count = counts[static_cast<std::size_t>(y * workbench.columns + x)];
      if (count == 0) continue;
      const double share = static_cast<double>(count) / static_cast<double>(most);
      svg += "<rect class=\"heat\"" + attribute("x", kEdge * x + 0.5) +
             attribute("y", kEdge * (workbench.rows - 1 - y) + 0.5) + attribute("width", kEdge) +
             attribute("height", kEdge) + " fill-opacity=\"" + decimal(0.15 + 0.75 * share, 2) +
             "\"/>";
    }
  }
  return svg + "</svg>";
}

}  // namespace conceptplan::report
