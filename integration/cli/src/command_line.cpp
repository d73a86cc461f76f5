#include "command_line.hpp"

#include <algorithm>
#include <limits>
#include <thread>

#include "conceptplan/domain/files/nearest_name.hpp"
#include "exit_code.hpp"
#include "number_range.hpp"

namespace conceptplan::cli {
namespace {

/// The command that was named last: "generate tasks" in `conceptplan generate tasks --level 3`.
const CLI::App* deepest(const CLI::App* app) {
  for (;;) {
    const std::vector<CLI::App*> named = app->get_subcommands();
    if (named.empty()) return app;
    app = named.front();
  }
}

std::string fullName(const CLI::App* app) {
  std::string name = app->get_name();
  for (app = app->get_parent(); app; app = app->get_parent()) name = app->get_name() + " " + name;
  return name;
}

std::vector<std::string> commandNames(const CLI::App* app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> optionNames(const CLI::App* app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string hint(const std::string& name, const std::vector<std::string>& candidates) {
  const std::vector<std::string_view> views(candidates.begin(), candidates.end());
  return didYouMean(name, views);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

CLI::Validator anySeed() {
  return inRange(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()).description("");
}

int defaultJobs() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

CommandLine::CommandLine() : app_("Visual task planning from two RGB-D pictures", "conceptplan") {
  app_.set_version_flag("--version", std::string("conceptplan ") + CONCEPTPLAN_VERSION);
  app_.footer(
      "conceptplan COMMAND --help explains a command. Exit codes: 0 done and solved, "
      "1 no plan,\n2 the call or an input is wrong, 3 internal failure, 130 interrupted.");
  options_.jobs = defaultJobs();
}

CLI::App& CommandLine::addGroup(const std::string& name, const std::string& summary) {
  return *app_.add_subcommand(name, summary);
}

CLI::App& CommandLine::add(CLI::App& parent, const std::string& name, const std::string& summary,
                           const std::string& example, CommandAction action) {
  CLI::App& command = *parent.add_subcommand(name, summary);
  command.footer("Example:\n  " + example);
  command
      .add_flag("--json", options_.json, "Print one JSON document on stdout, nothing else there")
      ->group("Common options");
  command.add_flag("--quiet", options_.quiet, "No progress and no messages, errors only")
      ->group("Common options");
  command.add_option("--seed", options_.seed, "Seed of everything that is drawn; 0 if left out")
      ->type_name("N")
      ->check(anySeed())
      ->group("Common options");
  command.add_option("--jobs", options_.jobs, "Threads; one a core if left out")
      ->type_name("N")
      ->check(inRange(1, 1024))
      ->group("Common options");
  command.callback([this, action = std::move(action)] { chosen_ = action; });
  return command;
}

int CommandLine::run(int argc, const char* const* argv, const std::atomic<bool>& cancel) {
  arguments_.assign(argv + 1, argv + argc);
  for (CLI::App* group : app_.get_subcommands([](const CLI::App*) { return true; })) {
    if (!commandNames(group).empty()) group->require_subcommand(1);
  }
  app_.require_subcommand(1);
  try {
    app_.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app_.exit(success);
  } catch (const CLI::ParseError& error) {
    const bool json = std::find(arguments_.begin(), arguments_.end(), "--json") != arguments_.end();
    const std::string message = explain(error);
    Console console(json, false);
    console.error("conceptplan: " + message);
    console.printJson({{"error", {{"kind", "call"}, {"message", message}}}});
    return kWrongInput;
  }
  Console console(options_.json, options_.quiet);
  Session session{options_, console, cancel};
  return perform(session);
}

int CommandLine::perform(Session& session) const {
  const auto report = [&](const char* kind, const std::string& message, const Json& faults) {
    Json error{{"kind", kind}, {"message", message}};
    if (!faults.empty()) error["faults"] = faults;
    session.console.printJson({{"error", error}});
  };
  try {
    return chosen_(session);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) {
      session.console.error("conceptplan: " + fault.text());
    }
    report("input", error.what(), toJson(error.faults()));
    return kWrongInput;
  } catch (const Interrupted&) {
    session.console.error("conceptplan: interrupted; what was finished is kept");
    report("interrupted", "interrupted; what was finished is kept", {});
    return kInterrupted;
  } catch (const std::exception& error) {
    session.console.error(std::string("conceptplan: internal failure: ") + error.what());
    report("internal", error.what(), {});
    return kInternalFailure;
  }
}

std::string CommandLine::explain(const CLI::ParseError& error) const {
  const CLI::App* command = deepest(&app_);
  const std::vector<std::string> commands = commandNames(command);
  const std::string ask = "; \"" + fullName(command) + " --help\" explains";
  const std::vector<std::string> extras = command->remaining(true);
  if (!commands.empty()) {
    // The first word after the group's own name is no command of it.
    const auto own = std::find(arguments_.begin(), arguments_.end(), command->get_name());
    const auto first =
        std::find_if(own == arguments_.end() ? arguments_.begin() : own + 1, arguments_.end(),
                     [](const std::string& word) { return word[0] != '-'; });
    if (first != arguments_.end()) {
      return "unknown command \"" + *first + "\"" + hint(*first, commands) + "; there are " +
             joined(commands);
    }
    if (dynamic_cast<const CLI::RequiredError*>(&error)) {
      return "a command is missing; there are " + joined(commands) + ask;
    }
  }
  const auto option = std::find_if(extras.begin(), extras.end(),
                                   [](const std::string& word) { return word.starts_with("-"); });
  if (option != extras.end()) {
    const std::string name = option->substr(0, option->find('='));
    return "unknown option " + name + hint(name, optionNames(command)) + ask;
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) && !extras.empty()) {
    return "unexpected argument \"" + extras.front() + "\"" + ask;
  }
  return std::string(error.what()) + ask;
}

}  // namespace conceptplan::cli
