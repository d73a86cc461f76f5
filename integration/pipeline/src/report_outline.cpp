#include "report_outline.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "report_markup.hpp"

namespace conceptplan::report {
namespace {

struct Point {
  int x = 0;
  int y = 0;
  auto operator<=>(const Point&) const = default;
};

// Edges of the instance's pixels against others, directed with the instance to their right, by
// where they start. A corner where two parts touch starts two of them.
using Edges = std::multimap<Point, Point>;

Edges boundary(const RgbdImage& image, std::uint8_t instance, Point low, Point high) {
  const auto inside = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < image.width && y < image.height &&
           image.mask[static_cast<std::size_t>(y) * image.width + x] == instance;
  };
  Edges edges;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (!inside(x, y)) continue;
      if (!inside(x, y - 1)) edges.emplace(Point{x, y}, Point{x + 1, y});
      if (!inside(x + 1, y)) edges.emplace(Point{x + 1, y}, Point{x + 1, y + 1});
      if (!inside(x, y + 1)) edges.emplace(Point{x + 1, y + 1}, Point{x, y + 1});
      if (!inside(x - 1, y)) edges.emplace(Point{x, y + 1}, Point{x, y});
    }
  }
  return edges;
}

// A closed path through the middles of a loop's edges, without those on a straight line.
std::string pathOf(const std::vector<Point>& corners) {
  std::string path;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point before = corners[(i + count - 1) % count];
    const Point from = corners[i];
    const Point to = corners[(i + 1) % count];
    const Point after = corners[(i + 2) % count];
    const Point along{to.x - from.x, to.y - from.y};
    const bool straight = from.x - before.x == along.x && from.y - before.y == along.y &&
                          after.x - to.x == along.x && after.y - to.y == along.y;
    if (straight) continue;
    path += path.empty() ? 'M' : 'L';
    path += decimal(0.5 * (from.x + to.x), 1) + ' ' + decimal(0.5 * (from.y + to.y), 1);
  }
  return path + 'Z';
}

}  // namespace

std::vector<Outline> outlines(const RgbdImage& image) {
  struct Box {
    Point low;
    Point high;
  };
  std::map<std::uint8_t, Box> boxes;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t id = image.mask[static_cast<std::size_t>(y) * image.width + x];
      if (id == 0) continue;
      Box& box = boxes.try_emplace(id, Box{{x, y}, {x, y}}).first->second;
      box.low = {std::min(box.low.x, x), std::min(box.low.y, y)};
      box.high = {std::max(box.high.x, x), std::max(box.high.y, y)};
    }
  }
  std::vector<Outline> all;
  for (const auto& [id, box] : boxes) {
    Outline outline{id, {}, 0.5 * (box.low.x + box.high.x + 1), static_cast<double>(box.low.y)};
    Edges edges = boundary(image, id, box.low, box.high);
    while (!edges.empty()) {
      std::vector<Point> corners;
      for (auto edge = edges.begin(); edge != edges.end(); edge = edges.find(corners.back())) {
        if (corners.empty()) corners.push_back(edge->first);
        corners.push_back(edge->second);
        edges.erase(edge);
      }
      corners.pop_back();  // the loop ends where it began
      outline.path += pathOf(corners);
    }
    all.push_back(std::move(outline));
  }
  return all;
}

}  // namespace conceptplan::report
