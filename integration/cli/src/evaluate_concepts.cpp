#include "evaluate_concepts.hpp"

#include "conceptplan/pipeline/concept_evaluation.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {

int evaluateConceptSet(const std::string& folder, const std::string& model, Session& session) {
  const ConceptDataset data(folder);
  const ConceptEvaluation result = evaluateConcepts(
      data, Model(findModel(model)),
      {session.options.seed, session.console.progress("pictures"), &session.cancel});
  if (session.cancel) throw Interrupted{};

  Json concepts = Json::array();
  TextTable table{{"concept", "right %", "calibration error"}};
  for (const Concept which : kConcepts) {
    const double accuracy = result.accuracy[index(which)];
    const double error = result.calibration_error[index(which)];
    concepts.push_back(
        {{"name", name(which)}, {"accuracy", accuracy}, {"calibration_error", error}});
    table.push_back({std::string(name(which)), decimal(100 * accuracy, 2), decimal(error, 4)});
  }
  table.push_back({"all six", decimal(100 * result.all_right, 2), ""});
  table.push_back({"told to fit no symbol", decimal(100 * result.fit_no_symbol, 2), ""});

  const DisentanglementScores& scores = result.disentanglement;
  Json measures = Json::object();
  TextTable measure_table{{"measure", "score"}};
  const auto add = [&](const char* key, const char* label, double score) {
    measures[key] = score;
    measure_table.push_back({label, decimal(score, 4)});
  };
  add("dci", "DCI disentanglement", scores.dci.disentanglement);
  add("dci_completeness", "DCI completeness", scores.dci.completeness);
  add("dci_informativeness", "DCI informativeness", scores.dci.informativeness);
  add("mig", "MIG", scores.mig);
  add("sap", "SAP", scores.sap);
  add("factor_vae", "FactorVAE score", scores.factor_vae);
  add("beta_vae", "beta-VAE score", scores.beta_vae);

  session.console.print(std::to_string(result.pictures) + " pictures, " + result.set);
  session.console.print(table);
  session.console.print(measure_table);
  session.console.printJson({{"set", result.set},
                             {"pictures", result.pictures},
                             {"concepts", concepts},
                             {"all_right", result.all_right},
                             {"fit_no_symbol", result.fit_no_symbol},
                             {"measures", measures}});
  return kDone;
}

}  // namespace conceptplan::cli
