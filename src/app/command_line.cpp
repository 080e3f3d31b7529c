#include "mote/app/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <new>

#include "mote/app/commands.hpp"
#include "mote/app/one_line.hpp"
#include "mote/app/sum_points.hpp"
#include "mote/operators/cores/all.hpp"
#include "mote/particles/failure.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/suggestion.hpp"
#include "mote/scenario/version.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {
namespace {

template <class Options>
void add_threads_and_quiet(CLI::App& command, Options& options) {
  command.add_option("--threads", options.threads, "OpenMP threads (default: all)")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--quiet", options.quiet, "print nothing but errors");
}

void add_strict(CLI::App& command, RunOptions& options) {
  command.add_flag("--strict", options.strict, "make errors of warnings");
}

void add_file(CLI::App& command, RunOptions& options, const std::string& what) {
  command.add_option("file", options.file, what)->required();
  command.add_option("--set", options.assignments, "key.path=value, in place of the file's value")
      ->take_all()
      ->expected(1);
}

void add_file_and_output(CLI::App& command, RunOptions& options, const std::string& what) {
  add_file(command, options, what);
  command.add_option("--out", options.out, "output folder (default: a new one in results/)");
  command.add_flag("--overwrite", options.overwrite, "replace former output in that folder");
  add_threads_and_quiet(command, options);
}

std::vector<std::string> core_names() {
  std::vector<std::string> names{"point"};
  for_each_type(VortexCores{}, [&]<class Core>() { names.emplace_back(Core::name); });
  return names;
}

void add_sum(CLI::App& command, SumOptions& options) {
  command.footer(
      "Points have the columns x, y and, in 3D, z, and as strengths\n"
      "  cauchy       strength, or strength_re and strength_im\n"
      "  gravity      mass, or strength\n"
      "  biot_savart  circulation, or strength; in 3D circulation_x, _y, _z or strength_x, _y, _z\n"
      "The result has a row for every target, in the order of its file, with the columns\n"
      "  cauchy       value_re, value_im: sum_j v_j/(s_i - t_j), with x + i y for points\n"
      "  gravity      potential, gradient_x, ...: sum_j m_j ln r in 2D, -sum_j m_j/r in 3D\n"
      "  biot_savart  velocity_x, ..., and with --gradient velocity_gradient_xx, _xy, ...\n"
      "The exit code is 1 if --verify finds an error above the tolerance.");
  command.add_option("points", options.points, "file of points, .csv or as studies read them")
      ->required();
  command.add_option("--kernel", options.kernel, "what is summed: cauchy, gravity or biot_savart")
      ->required()
      ->check(
          CLI::IsMember(std::vector<std::string>(std::begin(sum_kernels), std::end(sum_kernels))));
  command
      .add_option("--method", options.method,
                  "direct, power_series (cauchy with targets apart) or multipole (default)")
      ->check(
          CLI::IsMember(std::vector<std::string>(std::begin(sum_methods), std::end(sum_methods))));
  command.add_option(
      "--tolerance", options.tolerance,
      "error over the largest value of the result (default: 1e-8; multipole: 1e-13 to 1e-3)");
  command.add_option("--out", options.out, "file of the result, .csv")->required();
  command.add_option("--targets", options.targets,
                     "file of the points that get the sums (default: the sources themselves)");
  command.add_option("--core", options.core, "core of masses or vortices (default: point)")
      ->check(CLI::IsMember(core_names()));
  command.add_option("--core-size", options.core_size, "size of the core, in the unit of x");
  command.add_flag("--gradient", options.gradient, "give the gradient of the velocity, too");
  command.add_flag("--verify", options.verify,
                   "compare some targets with sums pair by pair in long double");
  command.add_flag("--overwrite", options.overwrite, "replace the file of the result");
  add_threads_and_quiet(command, options);
}

/// The commands, each with the options it takes and what it does.
class Commands {
 public:
  Commands(CLI::App& app, const Catalogue& catalogue) : catalogue_(catalogue) {
    CLI::App* run_command = add(app, "run", "run a scenario and certify the result",
                                [this] { return run(catalogue_, run_); });
    add_file_and_output(*run_command, run_, "scenario, a YAML file");
    add_strict(*run_command, run_);

    CLI::App* compare_command =
        add(app, "compare", "run a scenario with all combinations of values",
            [this] { return compare(catalogue_, compare_); });
    compare_command->footer(
        "The threads are shared out among the runs. The exit code is 0 if every run passed its "
        "own\n"
        "checks, but for those whose numerics must break down, and every expectation of the "
        "file's\n"
        "section 'compare' holds, otherwise 1.");
    add_file_and_output(*compare_command, compare_, "scenario, a YAML file");
    compare_command
        ->add_option("--vary", compare_.variations,
                     "key.path=value,value,..., in place of the file's values of that key")
        ->take_all()
        ->expected(1);
    add_strict(*compare_command, compare_);
    compare_command->add_option("--jobs", compare_.jobs, "runs at a time (default: by processors)")
        ->check(CLI::Range(1, 4096));

    CLI::App* study_command = add(app, "study", "measure operators on points, without time",
                                  [this] { return study(catalogue_, run_); });
    add_file_and_output(*study_command, run_, "study, a YAML file");

    CLI::App* check_command = add(app, "check", "validate and estimate; run nothing",
                                  [this] { return check(catalogue_, run_); });
    add_file(*check_command, run_, "scenario, a YAML file");
    add_strict(*check_command, run_);

    CLI::App* resume_command = add(app, "resume", "go on from the last snapshot of a run",
                                   [this] { return resume(catalogue_, run_); });
    resume_command->add_option("folder", run_.out, "output folder of the run")->required();
    add_threads_and_quiet(*resume_command, run_);
    add_strict(*resume_command, run_);

    CLI::App* export_command = add(app, "export", "write a snapshot as CSV or VTK",
                                   [this] { return export_frame(export_); });
    export_command->add_option("folder", export_.folder, "output folder of a run")->required();
    export_command->add_option("--frame", export_.frame, "number of the snapshot, or last");
    export_command->add_option("--to", export_.to, "file to write, .csv or .vtp")->required();
    export_command->add_flag("--overwrite", export_.overwrite, "replace the file");

    add_sum(
        *add(app, "sum", "sum over all pairs of anybody's points", [this] { return sum(sum_); }),
        sum_);

    CLI::App* list_command =
        add(app, "list", "what a scenario can name", [this] { return list(catalogue_, what_); });
    list_command->add_option("what", what_, "which list")
        ->required()
        ->check(CLI::IsMember(listable()));

    CLI::App* schema_command = add(app, "schema", "the JSON Schema of a scenario or study file",
                                   [this] { return print_schema(catalogue_, schema_of_); });
    schema_command->add_option("of", schema_of_, "scenario, study or stationary")
        ->check(CLI::IsMember({"scenario", "study", "stationary"}));
  }

  int exit_code() const { return exit_code_; }

 private:
  CLI::App* add(CLI::App& app, const std::string& name, const std::string& summary,
                std::function<int()> action) {
    CLI::App* command = app.add_subcommand(name, summary);
    command->callback([this, action = std::move(action)] { exit_code_ = action(); });
    return command;
  }

  const Catalogue& catalogue_;
  RunOptions run_;
  CompareOptions compare_;
  ExportOptions export_;
  SumOptions sum_;
  std::string what_, schema_of_ = "scenario";
  int exit_code_ = 0;
};

/// A first argument that is no command, told before the options confuse the matter.
void refuse_unknown_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, argv[1]) != names.end()) return;
  throw InputError(fmt::format("unknown command '{}'{}; there are: {}", argv[1],
                               suggestion(argv[1], names), fmt::join(names, ", ")));
}

/// The same for a first option.
void refuse_unknown_option(int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] != '-') return;
  const std::string option = argv[1];
  if (option != "--help" && option != "-h" && option != "--version")
    throw InputError(fmt::format("unknown option '{}' before the command", option));
}

int bad_input(const std::string& message) {
  fmt::print(stderr, "{}\n", one_line(message));
  return 2;
}

}  // namespace

int command_line(const Catalogue& catalogue, int argc, const char* const* argv) {
  CLI::App app("mote: meshless particle methods, with an accuracy certificate for every run");
  app.set_version_flag("--version", std::string(version));
  app.require_subcommand(1);
  Commands commands(app, catalogue);
  try {
    refuse_unknown_command(app, argc, argv);
    refuse_unknown_option(argc, argv);
    app.parse(argc, argv);
    return commands.exit_code();
  } catch (const CLI::Success& asked_for_help) {
    return app.exit(asked_for_help);
  } catch (const CLI::ParseError& error) {
    return bad_input(fmt::format("mote: {} (see mote --help)", error.what()));
  } catch (const LocatedError& error) {
    return bad_input(error.what());
  } catch (const InputError& error) {
    return bad_input(fmt::format("mote: {}", error.what()));
  } catch (const NumericalFailure& error) {
    fmt::print(stderr, "mote: numerical failure: {}. Likely cause: {}\n", error.what(),
               error.cause());
    return 3;
  } catch (const std::filesystem::filesystem_error& error) {
    return bad_input(fmt::format("mote: {}: {}", error.path1().string(), error.code().message()));
  } catch (const std::bad_alloc&) {
    return bad_input("mote: this needs more memory than the machine has");
  } catch (const std::exception& error) {
    return bad_input(fmt::format("mote: {}", error.what()));
  }
}

}  // namespace mote
