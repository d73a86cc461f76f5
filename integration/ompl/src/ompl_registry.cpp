#include "conceptplan/ompl/ompl_planner.hpp"

namespace conceptplan {
namespace {

struct OmplEntry {
  OmplAlgorithm algorithm;
  std::string name;
  std::string summary;
  std::string source;
  bool goal_bias = true;
  bool control_samples = true;
};

std::vector<PlannerOption> optionsOf(const OmplEntry& entry) {
  const OmplPlannerOptions standard;
  std::vector<PlannerOption> options{PlannerOption::legalityThreshold()};
  if (entry.goal_bias) {
    options.push_back(PlannerOption::number("goal_bias", "0.05", 0, 1,
                                            "share of the samples that are drawn at the goal"));
  }
  if (entry.control_samples) {
    options.push_back(
        PlannerOption::integer("control_samples", std::to_string(standard.control_samples), 1, 100,
                               "actions tried to come near a sample; the best is taken"));
  }
  if (entry.algorithm == OmplAlgorithm::kSst) {
    options.push_back(
        PlannerOption::integer("improvement_steps", std::to_string(standard.improvement_steps), 0,
                               1e6, "steps of a run after its first path, to find a shorter one"));
  }
  return options;
}

PlannerEntry entryOf(const OmplEntry& entry) {
  return {entry.name,
          entry.summary,
          entry.source,
          {"Plans are distinct, without loops, and ordered by length, then by the order of the "
           "actions; none is proved shortest. One run is made for each plan asked for, so there "
           "may be fewer.",
           "Every plan replays on the compiled graph, where each action has its most probable "
           "outcome.",
           "infeasible is proved by breadth-first search before any sampling; giving up is limit "
           "or timeout.",
           "The same seed gives the same plans unless the time limit strikes."},
          optionsOf(entry),
          [entry](const OptionValues& values) -> std::unique_ptr<Planner> {
            OmplPlannerOptions options;
            options.legality_threshold = values.number("legality_threshold");
            if (entry.goal_bias) options.goal_bias = values.number("goal_bias");
            if (entry.control_samples) {
              options.control_samples = static_cast<std::size_t>(values.number("control_samples"));
            }
            if (entry.algorithm == OmplAlgorithm::kSst) {
              options.improvement_steps =
                  static_cast<std::size_t>(values.number("improvement_steps"));
            }
            return std::make_unique<OmplPlanner>(entry.algorithm, options);
          }};
}

}  // namespace

void addOmplPlanners(PlannerRegistry& registry) {
  const std::vector<OmplEntry> entries{
      {OmplAlgorithm::kRrt, "ompl-rrt", "A tree that grows towards random states (OMPL).",
       "S. M. LaValle and J. J. Kuffner, Randomized kinodynamic planning, 2001, "
       "doi:10.1177/02783640122067453."},
      {OmplAlgorithm::kEst, "ompl-est", "A tree that grows where it is sparse (OMPL).",
       "D. Hsu, J.-C. Latombe and R. Motwani, Path planning in expansive configuration spaces, "
       "1999, doi:10.1142/S0218195999000285."},
      {OmplAlgorithm::kKpiece, "ompl-kpiece",
       "A tree that grows from the border of what it covers (OMPL).",
       "I. A. Sucan and L. E. Kavraki, Kinodynamic motion planning by interior-exterior cell "
       "exploration, 2008, doi:10.1007/978-3-642-00312-7_28.",
       true, false},
      {OmplAlgorithm::kSst, "ompl-sst",
       "A sparse tree of the shortest ways found, which goes on to shorten them (OMPL).",
       "Y. Li, Z. Littlefield and K. E. Bekris, Asymptotically optimal sampling-based kinodynamic "
       "planning, 2016, doi:10.1177/0278364915614386.",
       true, false},
      {OmplAlgorithm::kPdst, "ompl-pdst",
       "A tree of paths chosen by how finely they subdivide the space (OMPL).",
       "A. M. Ladd and L. E. Kavraki, Motion planning in the presence of drift, underactuation and "
       "discrete system changes, 2005, doi:10.15607/RSS.2005.I.031."},
      {OmplAlgorithm::kSyclopRrt, "ompl-syclop-rrt",
       "A tree led by searches over regions of the concepts with the most symbols (OMPL).",
       "E. Plaku, L. E. Kavraki and M. Y. Vardi, Motion planning with dynamics by a synergistic "
       "combination of layers of planning, 2010, doi:10.1109/TRO.2010.2047820.",
       false, true}};
  for (const OmplEntry& entry : entries) registry.add(entryOf(entry));
}

}  // namespace conceptplan
