#include <Eigen/Core>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "commands.hpp"
#include "conceptplan/domain/files/program_path.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "conceptplan/planners/pddl/fast_downward_planner.hpp"
#include "exit_code.hpp"
#include "loaded_libraries.hpp"

namespace conceptplan::cli {
namespace {

struct Check {
  std::string name;
  bool ok = true;
  std::string found;
  std::string advice;  ///< empty if there is nothing to mend
};

Check checkLibrary(const std::string& name, std::string_view file_begin) {
  const auto path = loadedLibrary(file_begin);
  if (path) return {name, true, path->filename().string(), ""};
  return {name, false, "not loaded", "the command was built without it"};
}

Check checkEigen() {
  std::ostringstream version;
  version << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION;
  return {"Eigen", true, version.str(), ""};
}

Check checkBlas() {
  static const std::string kAdvice = "install libopenblas0-openmp: ";
  auto path = loadedLibrary("libopenblas");
  if (!path) path = loadedLibrary("libblas");
  if (!path) return {"BLAS", false, "none loaded", kAdvice + "networks need a BLAS"};
  const std::string text = path->string();
  if (text.find("openblas") == std::string::npos) {
    return {"BLAS", false, text, kAdvice + "with another BLAS training is up to ten times slower"};
  }
  if (text.find("pthread") != std::string::npos) {
    return {"BLAS", false, text, kAdvice + "threads of this one fight those of OpenMP"};
  }
  return {"BLAS", true, text, ""};
}

Check checkThreads() {
  const unsigned cores = std::thread::hardware_concurrency();
  const char* const limit = std::getenv("OMP_NUM_THREADS");
  Check check{"threads", true, std::to_string(cores) + " cores", ""};
  if (limit) check.found += ", OMP_NUM_THREADS=" + std::string(limit);
  if (limit && std::atoi(limit) > static_cast<int>(cores)) {
    check.ok = false;
    check.advice = "set OMP_NUM_THREADS to " + std::to_string(cores) + " at most";
  }
  return check;
}

/// Needed by one test alone, so its absence is no fault.
Check checkChromium() {
  if (const auto program = findOnPath("chromium")) {
    return {"chromium", true, program->string(), ""};
  }
  return {"chromium", true, "not found", "optional: install chromium to test the report"};
}

/// A planner by that name where it is there, so its absence is no fault.
Check checkFastDownward() {
  if (const auto program = findFastDownward()) {
    return {"fast-downward", true, program->string(), ""};
  }
  return {"fast-downward", true, "not found", "optional: put it on the PATH to plan with it"};
}

/// The shipped model, all of its files checked and loaded.
Check checkModel() {
  try {
    const std::filesystem::path folder = findModel("default");
    const Model model(folder);
    return {"model", true, folder.string(), ""};
  } catch (const InputError& error) {
    return {"model", false, error.faults().front().text(),
            "conceptplan train all makes one; CONCEPTPLAN_MODELS names the folder of models"};
  }
}

int examine(Session& session) {
  const std::vector<Check> checks{
      {"conceptplan", true, CONCEPTPLAN_VERSION, ""},
      checkLibrary("Torch", "libtorch_cpu"),
      checkLibrary("OpenCV", "libopencv_core"),
      checkLibrary("Embree", "libembree"),
      checkLibrary("FCL", "libfcl"),
      checkLibrary("NLopt", "libnlopt"),
      checkLibrary("yaml-cpp", "libyaml-cpp"),
      checkEigen(),
      checkBlas(),
      checkThreads(),
      checkModel(),
      checkChromium(),
      checkFastDownward(),
  };
  Json list = Json::array();
  TextTable table{{"", "check", "found", "advice"}};
  bool all_ok = true;
  for (const Check& check : checks) {
    all_ok = all_ok && check.ok;
    list.push_back(
        {{"name", check.name}, {"ok", check.ok}, {"found", check.found}, {"advice", check.advice}});
    table.push_back({check.ok ? "ok" : "WRONG", check.name, check.found, check.advice});
  }
  session.console.printJson({{"ok", all_ok}, {"checks", list}});
  session.console.print(table);
  return all_ok ? kDone : kWrongInput;
}

}  // namespace

void addDoctorCommand(CommandLine& line) {
  line.add("doctor", "Check versions, threads, BLAS and the model, and say what is wrong",
           "conceptplan doctor", examine);
}

}  // namespace conceptplan::cli
