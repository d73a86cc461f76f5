// Reads what `planning_benchmark --benchmark_out=FILE` wrote, draws how costs grow, and prints the
// figures and ratios of docs/performance.md as Markdown.
//
// performance_figures FILE.json FIGURE.svg

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "report_markup.hpp"
#include "svg_drawing.hpp"

namespace conceptplan {
namespace {

using figures::Anchor;
using figures::Point;
using figures::SvgDrawing;
using report::decimal;

/// The medians of one benchmark over its repetitions.
struct Measured {
  double milliseconds = 0;  ///< processor time of one iteration
  double items_per_second = 0;
  std::map<std::string, double> counters;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class Results {
 public:
  explicit Results(const std::string& path) {
    std::map<std::string, std::vector<nlohmann::json>> runs;
    const auto document = nlohmann::json::parse(readFile(path));
    for (const auto& run : document.at("benchmarks")) {
      if (run.at("run_type") == "iteration") runs[run.at("run_name")].push_back(run);
    }
    for (const auto& [name, all] : runs) {
      const auto middle = [&](const char* key) {
        std::vector<double> values;
        for (const auto& run : all) values.push_back(run.value(key, 0.0));
        return median(values);
      };
      const double unit = all.front().at("time_unit") == "ms" ? 1 : 1e-6;
      Measured& measured = measured_[name];
      measured.milliseconds = unit * middle("cpu_time");
      measured.items_per_second = middle("items_per_second");
      for (const char* key : {"peak_MB", "graph_MB", "difference", "sweeps", "path_cost"}) {
        measured.counters[key] = middle(key);
      }
    }
  }

  const Measured& operator[](const std::string& name) const {
    const auto found = measured_.find(name);
    if (found == measured_.end()) throw std::runtime_error("no benchmark " + name);
    return found->second;
  }

  /// The benchmark at each of its arguments, by rising argument.
  std::vector<std::pair<double, Measured>> curve(const std::string& name) const {
    std::vector<std::pair<double, Measured>> points;
    for (const auto& [full, measured] : measured_) {
      if (!full.starts_with(name + "/")) continue;
      points.emplace_back(std::stod(full.substr(name.size() + 1)), measured);
    }
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return points;
  }

 private:
  std::map<std::string, Measured> measured_;
};

struct Curve {
  std::string benchmark;
  std::string label;
};

struct Chart {
  std::string title;
  std::string x_label;
  std::vector<Curve> curves;
};

const std::vector<Chart>& charts() {
  static const std::vector<Chart> all{
      {"Workbench of n x n cells",
       "n; four rotations, 10 % of the cells taken",
       {{"compileBySide", "compile"},
        {"searchBySide/astar", "astar"},
        {"searchBySide/dijkstra", "dijkstra"},
        {"searchBySide/kbest", "kbest"},
        {"searchBySide/value_iteration", "value-iteration"}}},
      {"Values of a concept",
       "rotations; 50 x 50 cells, 10 % taken",
       {{"compileByValues", "compile"},
        {"searchByValues/astar", "astar"},
        {"searchByValues/dijkstra", "dijkstra"}}},
      {"Obstacles",
       "objects beside the target; 50 x 50 cells, four rotations",
       {{"compileByObstacles<GridValidity>", "compile, cells alone"},
        {"compileByObstacles<FclValidity>", "compile, FCL"},
        {"astarByObstacles", "astar"}}},
      {"Plans asked for",
       "k; level 4, compiled with FCL and solved",
       {{"solveLevelFour/kbest", "kbest"}, {"solveLevelFour/astar", "astar"}}}};
  return all;
}

/// A logarithmic axis over whole decades.
class LogAxis {
 public:
  LogAxis(double least, double most, double from, double to)
      : first_(std::floor(std::log10(least))),
        last_(std::max(std::ceil(std::log10(most)), first_ + 1)),
        from_(from),
        to_(to) {}

  double at(double value) const {
    return from_ + (std::log10(value) - first_) / (last_ - first_) * (to_ - from_);
  }
  int firstDecade() const { return static_cast<int>(first_); }
  int lastDecade() const { return static_cast<int>(last_); }

 private:
  double first_, last_, from_, to_;
};

std::string decade(int power) {
  return power >= 0 ? decimal(std::pow(10, power), 0) : decimal(std::pow(10, power), -power);
}

constexpr double kWidth = 520;
constexpr double kHeight = 400;
constexpr std::string_view kColors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#7a5c00"};
constexpr std::string_view kGrid = "#dfe3e8";

void drawChart(const Chart& chart, const Results& results, Point corner, SvgDrawing& drawing) {
  const double left = corner.x + 70, right = corner.x + kWidth - 150;
  const double top = corner.y + 50, bottom = corner.y + kHeight - 60;
  double x_least = 1e300, x_most = 0, y_least = 1e300, y_most = 0;
  for (const Curve& curve : chart.curves) {
    for (const auto& [x, measured] : results.curve(curve.benchmark)) {
      x_least = std::min(x_least, x);
      x_most = std::max(x_most, x);
      y_least = std::min(y_least, measured.milliseconds);
      y_most = std::max(y_most, measured.milliseconds);
    }
  }
  const LogAxis x_axis(x_least, x_most, left, right);
  const LogAxis y_axis(y_least, y_most, bottom, top);
  drawing.text({left, corner.y + 24}, chart.title, {18, Anchor::kStart, true});
  drawing.text({left, corner.y + 42}, "milliseconds", {13, Anchor::kStart, false, figures::kQuiet});
  for (int power = x_axis.firstDecade(); power <= x_axis.lastDecade(); ++power) {
    const double x = x_axis.at(std::pow(10, power));
    drawing.line({x, top}, {x, bottom}, kGrid);
    drawing.text({x, bottom + 18}, decade(power), {13, Anchor::kMiddle});
  }
  for (int power = y_axis.firstDecade(); power <= y_axis.lastDecade(); ++power) {
    const double y = y_axis.at(std::pow(10, power));
    drawing.line({left, y}, {right, y}, kGrid);
    drawing.text({left - 8, y + 5}, decade(power), {13, Anchor::kEnd});
  }
  drawing.text({left, bottom + 40}, chart.x_label, {13, Anchor::kStart, false, figures::kQuiet});

  struct Label {
    double y;
    std::string text;
    std::string_view color;
  };
  std::vector<Label> labels;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    std::vector<Point> points;
    for (const auto& [x, measured] : results.curve(chart.curves[i].benchmark)) {
      points.push_back({x_axis.at(x), y_axis.at(measured.milliseconds)});
    }
    if (points.empty()) throw std::runtime_error("no benchmark " + chart.curves[i].benchmark);
    for (std::size_t p = 1; p < points.size(); ++p) {
      drawing.line(points[p - 1], points[p], kColors[i], 2);
    }
    drawing.dots(points, kColors[i], 8);
    labels.push_back({points.back().y, chart.curves[i].label, kColors[i]});
  }
  // Beside the axis, in the order of the ends of the curves, none over another.
  std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  double lowest = top - 20;
  for (const Label& label : labels) {
    lowest = std::max(label.y, lowest + 18);
    drawing.text({right + 10, lowest + 5}, label.text, {14, Anchor::kStart, true, label.color});
  }
}

std::string drawn(const Results& results) {
  SvgDrawing drawing(2 * kWidth, 2 * kHeight, "Cost of planning",
                     "Milliseconds of compiling and of searching against the size of the "
                     "workbench, the values of a concept, the obstacles and the plans asked for, "
                     "on logarithmic axes.");
  for (std::size_t i = 0; i < charts().size(); ++i) {
    drawChart(charts()[i], results,
              {kWidth * static_cast<double>(i % 2), kHeight * static_cast<double>(i / 2)}, drawing);
  }
  return drawing.svg();
}

/// Enough decimals to tell figures apart.
std::string figure(double value) {
  return decimal(value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

void printCurves(const Results& results) {
  for (const Chart& chart : charts()) {
    std::map<double, std::map<std::string, double>> rows;
    std::cout << "\n" << chart.title << ", milliseconds\n\n| " << chart.x_label << " |";
    for (const Curve& curve : chart.curves) {
      std::cout << " " << curve.label << " |";
      for (const auto& [x, measured] : results.curve(curve.benchmark)) {
        rows[x][curve.label] = measured.milliseconds;
      }
    }
    std::cout << "\n|---|";
    for (std::size_t i = 0; i < chart.curves.size(); ++i) std::cout << "---|";
    for (const auto& [x, row] : rows) {
      std::cout << "\n| " << decimal(x, 0) << " |";
      for (const Curve& curve : chart.curves) {
        const auto cell = row.find(curve.label);
        std::cout << " " << (cell == row.end() ? "" : figure(cell->second)) << " |";
      }
    }
    std::cout << "\n";
  }
}

void printRatios(const Results& results) {
  std::cout << "\n| level 4 | scenarios a second |\n|---|---|\n";
  for (const char* name :
       {"compileLevelFour/grid", "compileLevelFour/fcl", "solveLevelFour/kbest/5",
        "solveLevelFour/astar/5", "solveLevelFour/dijkstra/5", "solveLevelFour/belief/5"}) {
    std::cout << "| " << name << " | " << decimal(results[name].items_per_second, 0) << " |\n";
  }
  std::cout << "\n| A* | expansions a second | peak MB | graph MB | path cost |\n"
               "|---|---|---|---|---|\n";
  const Measured& ours = results["ourAstar"];
  for (const char* name : {"ourAstar", "ourPlanner", "boostOverOurGraph", "boostOverItsGraph"}) {
    const Measured& measured = results[name];
    std::cout << "| " << name << " | " << decimal(measured.items_per_second, 0) << " | "
              << decimal(measured.counters.at("peak_MB"), 1) << " | "
              << decimal(measured.counters.at("graph_MB"), 1) << " | "
              << decimal(measured.counters.at("path_cost"), 6) << " |\n";
  }
  for (const char* name : {"boostOverOurGraph", "boostOverItsGraph"}) {
    const Measured& boost = results[name];
    std::cout << "\nourAstar to " << name << ": "
              << figure(ours.items_per_second / boost.items_per_second) << " times the expansions, "
              << figure(ours.counters.at("peak_MB") / boost.counters.at("peak_MB"))
              << " of the memory\n";
  }
  const Measured& sweeps = results["sparseMatrixSweeps"];
  for (const char* name : {"ourValueIteration", "ourValueIterationPlanner"}) {
    std::cout << "\n"
              << name << ": " << figure(results[name].milliseconds) << " ms, sparse matrices "
              << figure(sweeps.milliseconds) << " ms in "
              << decimal(sweeps.counters.at("sweeps"), 0) << " sweeps, ratio "
              << figure(sweeps.milliseconds / results[name].milliseconds) << "\n";
  }
  std::cout << "\nlargest difference of a value: "
            << results["ourValueIteration"].counters.at("difference") << "\n";
}

}  // namespace
}  // namespace conceptplan

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: performance_figures FILE.json FIGURE.svg\n";
    return 2;
  }
  try {
    const conceptplan::Results results(arguments[1]);
    conceptplan::writeFileAtomically(arguments[2], conceptplan::drawn(results));
    conceptplan::printRatios(results);
    conceptplan::printCurves(results);
  } catch (const std::exception& error) {
    std::cerr << "performance_figures: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
