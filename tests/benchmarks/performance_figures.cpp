// Reads what `planning_benchmark --benchmark_out=RESULTS.json` wrote, draws how costs grow, and
// writes the tables of docs/performance.md. Then it fails, naming them, if bounds are missed.
//
// performance_figures RESULTS.json DOCS

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
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
  double milliseconds = 0;  ///< processor time of one problem
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
      if (run.value("error_occurred", false))
        throw std::runtime_error(run.at("name").get<std::string>() +
                                 " failed: " + run.value("error_message", ""));
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
      measured.milliseconds = unit * middle("cpu_time") / std::max(1.0, middle("problems"));
      measured.items_per_second = middle("items_per_second");
      for (const char* key :
           {"peak_MB", "graph_MB", "difference", "sweeps", "path_cost", "expanded"}) {
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
      // Arguments may have names: "targets:2".
      points.emplace_back(std::stod(full.substr(full.find_last_of("/:") + 1)), measured);
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
       {{"solveLevelFour/kbest", "kbest"}, {"solveLevelFour/astar", "astar"}}},
      {"Targets",
       "targets in one task; joint A*, a tenth of the cells taken",
       {{"drawnBenches/side:4", "4 x 4 cells"},
        {"drawnBenches/side:8", "8 x 8 cells"},
        {"drawnBenches/side:16", "16 x 16 cells"}}}};
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
  SvgDrawing drawing(2 * kWidth, 3 * kHeight, "Cost of planning",
                     "Milliseconds of compiling and of searching against the size of the "
                     "workbench, the values of a concept, the obstacles, the plans asked for and "
                     "the targets, on logarithmic axes.");
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

std::string curveTables(const Results& results) {
  std::string text;
  for (const Chart& chart : charts()) {
    std::map<double, std::map<std::string, double>> rows;
    std::string head = "| " + chart.x_label + " |";
    std::string rule = "|---|";
    for (const Curve& curve : chart.curves) {
      head += " " + curve.label + " |";
      rule += "---|";
      for (const auto& [x, measured] : results.curve(curve.benchmark)) {
        rows[x][curve.label] = measured.milliseconds;
      }
    }
    text += "\n### " + chart.title + ", milliseconds\n\n" + head + "\n" + rule + "\n";
    for (const auto& [x, row] : rows) {
      text += "| " + decimal(x, 0) + " |";
      for (const Curve& curve : chart.curves) {
        const auto cell = row.find(curve.label);
        text += " " + (cell == row.end() ? "" : figure(cell->second)) + " |";
      }
      text += "\n";
    }
  }
  return text;
}

struct Row {
  const char* benchmark;
  const char* label;
};

std::string scenarioTable(const Results& results) {
  constexpr Row kRows[] = {{"compileLevelFour/grid", "compile, validity of cells alone"},
                           {"compileLevelFour/fcl", "compile, validity by FCL"},
                           {"solveLevelFour/kbest/5", "compile with FCL, exact top 5 by `kbest`"},
                           {"solveLevelFour/astar/5", "the same by `astar`"},
                           {"solveLevelFour/dijkstra/5", "the same by `dijkstra`"},
                           {"solveLevelFour/belief/5", "compile with FCL, top 5 by `belief`"}};
  std::string text = "\n### Level-4 scenarios\n\n| | scenarios a second |\n|---|---|\n";
  for (const Row& row : kRows) {
    text += std::string("| ") + row.label + " | " +
            decimal(results[row.benchmark].items_per_second, 0) + " |\n";
  }
  return text;
}

double memoryInAll_MB(const Measured& measured) {
  return measured.counters.at("peak_MB") + measured.counters.at("graph_MB");
}

std::string astarTable(const Results& results) {
  constexpr Row kRows[] = {
      {"ourAstar", "ours, the search alone"},
      {"ourPlanner", "ours, the planner `astar`: with heuristic, plan and trace"},
      {"boostOverItsGrid", "Boost.Graph over its filtered grid_graph"},
      {"boostOverOurGraph", "Boost.Graph over our successor function"},
      {"boostOverItsGraph", "Boost.Graph over its compressed_sparse_row_graph"}};
  std::string text =
      "\n### A* on 1,000 x 1,000 cells\n\n| | expansions | milliseconds | expansions a second | "
      "memory of the search, MB | of the graph, MB | cost of the path | our rate to this | our "
      "time to this | our memory to this | with the graphs |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n";
  const Measured& ours = results["ourAstar"];
  for (const Row& row : kRows) {
    const Measured& measured = results[row.benchmark];
    text += std::string("| ") + row.label + " | " + decimal(measured.counters.at("expanded"), 0) +
            " | " + figure(measured.milliseconds) + " | " + decimal(measured.items_per_second, 0) +
            " | " + decimal(measured.counters.at("peak_MB"), 1) + " | " +
            decimal(measured.counters.at("graph_MB"), 1) + " | " +
            decimal(measured.counters.at("path_cost"), 6) + " | " +
            figure(ours.items_per_second / measured.items_per_second) + " | " +
            figure(ours.milliseconds / measured.milliseconds) + " | " +
            figure(ours.counters.at("peak_MB") / measured.counters.at("peak_MB")) + " | " +
            figure(memoryInAll_MB(ours) / memoryInAll_MB(measured)) + " |\n";
  }
  return text;
}

std::string valueIterationTable(const Results& results) {
  constexpr Row kRows[] = {{"sparseMatrixSweeps", "sparse matrices of Eigen, sweeps alone"},
                           {"ourValueIteration", "ours, from the graph to the values"},
                           {"ourValueIterationPlanner", "ours, the planner `value-iteration`"}};
  std::string text =
      "\n### Value iteration\n\n| | milliseconds | ours is faster |\n|---|---|---|\n";
  const Measured& sweeps = results["sparseMatrixSweeps"];
  for (const Row& row : kRows) {
    const double milliseconds = results[row.benchmark].milliseconds;
    text += std::string("| ") + row.label + " | " + figure(milliseconds) + " | " +
            figure(sweeps.milliseconds / milliseconds) + " times |\n";
  }
  const double billionths = 1e9 * results["ourValueIteration"].counters.at("difference");
  return text + "\nEigen's took " + decimal(sweeps.counters.at("sweeps"), 0) +
         " sweeps. The values differ by at most " + decimal(billionths, 1) + " billionths.\n";
}

/// What the product promises and the results miss.
std::vector<std::string> missedBounds(const Results& results) {
  std::vector<std::string> missed;
  const auto expect = [&missed](const std::string& what, double found, double least) {
    if (!(found >= least))
      missed.push_back(what + ": " + figure(found) + ", at least " + figure(least));
  };
  const Measured& ours = results["ourAstar"];
  for (const char* boost : {"boostOverItsGrid", "boostOverItsGraph"}) {
    const Measured& theirs = results[boost];
    expect(std::string("A*, rate of expansions to that of ") + boost,
           ours.items_per_second / theirs.items_per_second, 4);
    expect(std::string("A*, memory of ") + boost + " to ours",
           memoryInAll_MB(theirs) / memoryInAll_MB(ours), 2);
  }
  expect("value iteration, time of sparseMatrixSweeps to ours",
         results["sparseMatrixSweeps"].milliseconds / results["ourValueIteration"].milliseconds, 3);
  expect("exact top 5 of level-4 scenarios a second",
         std::max(results["solveLevelFour/kbest/5"].items_per_second,
                  results["solveLevelFour/astar/5"].items_per_second),
         5000);
  return missed;
}

/// The page up to and with the line behind which figures stand.
std::string textBefore(const std::string& page) {
  const std::string marker = "<!-- written by performance_figures from here on -->\n";
  const std::size_t at = page.find(marker);
  if (at == std::string::npos) throw std::runtime_error("the page has no line " + marker);
  return page.substr(0, at + marker.size());
}

}  // namespace
}  // namespace conceptplan

int main(int count, char** arguments) {
  using namespace conceptplan;
  if (count != 3) {
    std::cerr << "usage: performance_figures RESULTS.json DOCS\n";
    return 2;
  }
  try {
    const Results results(arguments[1]);
    const std::filesystem::path docs(arguments[2]);
    writeFileAtomically(docs / "images" / "performance.svg", drawn(results));
    const std::filesystem::path page = docs / "performance.md";
    writeFileAtomically(page, textBefore(readFile(page)) + scenarioTable(results) +
                                  astarTable(results) + valueIterationTable(results) +
                                  curveTables(results));
    const std::vector<std::string> missed = missedBounds(results);
    for (const std::string& bound : missed) std::cerr << "performance_figures: " << bound << "\n";
    return missed.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << "performance_figures: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
