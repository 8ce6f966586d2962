#include "apps/karat/run_karat.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "apps/karat/command.h"
#include "render/version.h"
#include "spectral/support/error.h"

namespace karat {
namespace {

const auto kStart = std::chrono::steady_clock::now();

std::string version_text() {
  return fmt::format("karat {}{}\n{}\n{}", version(), commit().empty() ? "" : " (" + commit() + ")",
                     compiler(), libraries());
}

int fail(int code, const std::string& message) {
  std::fflush(stdout);
  fmt::print(stderr, "karat: error: {}\n", printable(message));
  return code;
}

// In alphabetical order, in which "nk" stands before "nk list".
void add_commands(CLI::App& app, std::function<int()>& action) {
  const auto& commands = Registry<Command>::instance();
  for (const std::string& name : commands.names()) {
    const std::size_t space = name.find(' ');
    CLI::App* parent =
        space == std::string::npos ? &app : app.get_subcommand(name.substr(0, space));
    commands.find(name)->add_to(*parent, action);
  }
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// The program, the command that was given, and the command within that one.
std::vector<const CLI::App*> chosen_apps(const CLI::App& app) {
  std::vector<const CLI::App*> chain{&app};
  for (auto chosen = app.get_subcommands(); !chosen.empty();) {
    chain.push_back(chosen.front());
    chosen = chain.back()->get_subcommands();
  }
  return chain;
}

std::string unknown_command(const CLI::App& app, std::size_t depth,
                            const std::vector<std::string>& arguments) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands(nullptr)) known.push_back(command->get_name());
  if (known.empty()) return "";
  for (const auto& argument : arguments) {
    if (argument.empty() || argument.front() == '-' || depth-- > 0) continue;
    return unknown_name_message("command", argument, known);
  }
  return "";
}

// What the user wrote that nothing is known about: the first option that `app` does not have.
std::string unknown_option(const CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<std::string> options = option_names(app);
  for (const auto& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    const bool known = std::find(options.begin(), options.end(), name) != options.end();
    if (name.starts_with("--") && name.size() > 2 && !known) {
      const std::string near = nearest_name(name, options);
      return "unknown option " + name + (near.empty() ? "" : "; did you mean " + near + "?");
    }
  }
  return "";
}

int usage_error(const CLI::App& app, const CLI::ParseError& error,
                const std::vector<std::string>& arguments) {
  const auto chain = chosen_apps(app);
  std::string message = unknown_command(*chain.back(), chain.size() - 1, arguments);
  if (message.empty()) message = unknown_option(*chain.back(), arguments);
  if (message.empty()) message = error.what();
  std::string command = "karat";
  for (std::size_t i = 1; i < chain.size(); ++i) command += " " + chain[i]->get_name();
  return fail(kWrongUsage, message + "\nSee " + command + " --help.");
}

int run_action(const std::function<int()>& action) {
  try {
    return action();
  } catch (const UsageError& error) {
    return fail(kWrongUsage, error.what());
  } catch (const InputError& error) {
    return fail(kInvalidInput, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "out of memory");
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}

}  // namespace

std::string printable(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool control = (byte < 0x20 && c != '\n') || byte == 0x7f;
    shown += control ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return shown;
}

double seconds_since_start() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - kStart).count();
}

int run_karat(int argc, const char* const* argv) {
  CLI::App app{"Karat renders real materials from their measured complex refractive indices.",
               "karat"};
  app.set_version_flag("--version,-V", version_text());
  app.require_subcommand(1);
  app.footer("Example: karat render data/scenes/rings.json -o rings.exr -o rings.png");
  std::function<int()> action;
  add_commands(app, action);

  const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are "errors" that succeed.
    if (error.get_exit_code() == 0) return app.exit(error, std::cout, std::cerr);
    return usage_error(app, error, arguments);
  }
  if (!action) return fail(kWrongUsage, "no command given\nSee karat --help.");
  return run_action(action);
}

}  // namespace karat
