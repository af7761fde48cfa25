#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/program.h"
#include "app/cli/study/study_file.h"
#include "app/cli/study/study_output.h"
#include "app/cli/study/sweep_flight.h"
#include "core/io/files/scenario_json.h"
#include "core/plan/policy/policy.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>

namespace berg::cli {

namespace {

/** "0:5:0.5" or "0,0.5,1" or both mixed; the end of a range is included. 100 000 values in all. */
std::vector<double> tausOf(const std::string& text)
{
    constexpr std::size_t kMost = 100000;
    constexpr double kPerUnit = 1e9; // 3 * 0.1 is meant to be 0.3
    std::vector<double> taus;
    for (const std::string& part : split(text, ',')) {
        const std::vector<std::string> range = split(part, ':');
        const double first = numberOf("--tau", range.empty() ? part : range[0]);
        const double last = range.size() > 1 ? numberOf("--tau", range[1]) : first;
        const double step = range.size() > 2 ? numberOf("--tau", range[2]) : 1;
        if (range.size() == 2 || range.size() > 3 || !(step > 0) || first < 0 || last < first ||
            last > 100)
            throw UsageError(QT_TRANSLATE_NOOP("CommandLine",
                                               "--tau: %1 is not A:B:STEP with 0 <= A <= B <= 100"),
                             {part});
        if (static_cast<double>(taus.size()) + (last - first) / step >= static_cast<double>(kMost))
            throw UsageError(
                QT_TRANSLATE_NOOP("CommandLine", "--tau: with %1 there are more than %2 values"),
                {part, countOf(kMost)});
        const auto count = static_cast<int>(std::floor((last - first) / step + 1e-9));
        for (int k = 0; k <= count; ++k)
            taus.push_back(std::round((first + k * step) * kPerUnit) / kPerUnit);
    }
    return taus;
}

struct SweepArguments
{
    std::vector<std::string> files;
    int random = 0;
    std::optional<FieldRegime> regime;
    std::optional<std::int64_t> firstSeed;
    std::string taus;
    std::string policies = "visitation";
    int runs = 1;
    int threads = 0;
    std::string shard;
    StudyOutput output;
};

std::vector<PolicyKind> policiesOf(const std::string& names)
{
    std::vector<PolicyKind> policies;
    for (const std::string& name : split(names, ',')) {
        const auto policy = valueOf(kPolicyNames, name);
        if (!policy)
            throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--policies: %1 is none of %2"),
                             {name, allowedNames(kPolicyNames)});
        policies.push_back(*policy);
    }
    return policies;
}

StudySpec specOf(const SweepArguments& arguments)
{
    StudySpec spec{.random = arguments.random,
                   .firstSeed = arguments.firstSeed.value_or(1),
                   .taus = tausOf(arguments.taus),
                   .policies = policiesOf(arguments.policies),
                   .runs = arguments.runs};
    if (arguments.regime && arguments.random == 0)
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--regime needs --random N; scenario files define their own drift"));
    if (arguments.firstSeed && arguments.random == 0)
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--first-seed needs --random N; scenario files have their own seeds"));
    spec.field.regime = arguments.regime.value_or(FieldRegime::Published);
    if (arguments.files.empty() && arguments.random == 0)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "name scenarios, or use --random N"));
    for (const std::string& file : arguments.files)
        spec.scenarios.push_back(loadScenario(file));
    return spec;
}

Shard shardOf(const std::string& text)
{
    if (text.empty())
        return {};
    Shard shard{.index = 0};
    char rest = 0;
    if (text.find_first_not_of("0123456789/") != std::string::npos ||
        std::sscanf(text.c_str(), "%9d/%9d%c", &shard.index, &shard.count, &rest) != 2 ||
        shard.index < 1 || shard.index > shard.count)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--shard: %1 is not I/N with 1 <= I <= N"), {text});
    return shard;
}

void checkTogether(const SweepArguments& arguments)
{
    const bool isPart = shardOf(arguments.shard).count > 1;
    if (isPart && arguments.output.studyFile.empty())
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--shard needs --study FILE, in which the part is stored"));
    if (isPart && arguments.output.writesFiles())
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--shard: to write tables and reports of all shards, use 'study'"));
}

/** One `sweep` of the command line. */
class SweepRun
{
public:
    explicit SweepRun(const SweepArguments& arguments)
        : m_arguments(arguments), m_file(arguments.output.studyFile, arguments.output.replaceStudy)
    {
    }

    int run(const std::stop_token& stop, const std::string& commandLine)
    {
        const StudyOptions options{
            .threads = m_arguments.threads > 0 ? std::optional(m_arguments.threads) : std::nullopt,
            .shard = shardOf(m_arguments.shard),
            .stop = stop};
        const SweepLead lead{
            .prepare = [this] { return prepare(); },
            .progress = [this](const Study& study, std::size_t done,
                               std::size_t count) { progress(study, done, count); },
            .keep = [this](const Study& study) { keep(study); },
            .finish = [this](const Study& study,
                             bool complete) { return finish(study, complete); }};
        return mpiRank() ? flyOnRanks(lead, options, commandLine) : flyAlone(lead, options);
    }

private:
    Study prepare()
    {
        checkTogether(m_arguments);
        checkFiles(filesOf(m_arguments.output, m_arguments.files));
        Study study = reading([this] { return m_file.open(specOf(m_arguments)); });
        if (std::vector<Issue> issues = validate(study.spec); !issues.empty())
            throw Error(ErrorCode::InvalidInput, "sweep", std::move(issues));
        static_cast<void>(referenceOf(study.spec, m_arguments.output));
        return study;
    }

    void progress(const Study& study, std::size_t done, std::size_t count)
    {
        if (!m_bar)
            m_bar.emplace(said(QT_TRANSLATE_NOOP("CommandLine", "flying %1 missions"),
                               {grouped(static_cast<double>(count))}),
                          !m_arguments.output.json);
        m_bar->update(count > 0 ? static_cast<double>(done) / static_cast<double>(count) : 1);
        m_file.saveSometimes(study);
    }

    void keep(const Study& study)
    {
        m_bar.reset();
        try {
            if (flownCount(study) > 0)
                m_file.save(study);
        } catch (const Error&) {
            m_saveFailure = std::current_exception(); // reported after the results
        }
    }

    int finish(const Study& study, bool complete)
    {
        if (complete) {
            writeResults(
                study, m_arguments.output, [this] { reportWhatWasNotStored(); },
                m_watch.elapsed_s());
            return kDone;
        }
        reportWhatWasNotStored();
        if (!m_file.isStored())
            throw Interrupted{};
        printMessage(said(
            QT_TRANSLATE_NOOP(
                "CommandLine",
                "interrupted: %1 of %2 missions are stored in %3; repeat the command to continue"),
            {grouped(static_cast<double>(flownCount(study))),
             grouped(static_cast<double>(missionCount(study.spec))), m_file.path()}));
        return kInterrupted;
    }

    void reportWhatWasNotStored() const
    {
        if (m_saveFailure)
            std::rethrow_exception(m_saveFailure);
    }

    const SweepArguments& m_arguments;
    StudyFile m_file;
    Stopwatch m_watch;
    std::optional<ProgressBar> m_bar;
    std::exception_ptr m_saveFailure;
};

} // namespace

void addSweepCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand("sweep", "Measure zeta against tau and policy");
    const auto arguments = std::make_shared<SweepArguments>();
    SweepArguments& a = *arguments;
    command->add_option("SCENARIO", a.files, "Scenarios to fly");
    command->add_option("--random", a.random, "Also fly N random scenarios (none)")
        ->transform(wholeFrom(1, 1000000));
    addNamed(*command, "--regime", a.regime, kFieldRegimeNames,
             "Knowledge of drift in random scenarios (published)");
    command->add_option("--first-seed", a.firstSeed, "Seed of the first random scenario (1)")
        ->transform(wholeFrom(0, (std::int64_t{1} << 53) - 1000000));
    command->add_option("-t,--tau", a.taus, "A:B:STEP, or values with commas")->required();
    command->add_option("--policies", a.policies,
                        "With commas (visitation): " + allowedNames(kPolicyNames));
    command->add_option("--runs", a.runs, "Noise seeds for each scenario (1)")
        ->transform(wholeFrom(1, 1000000));
    command
        ->add_option("--threads", a.threads,
                     "Threads, which never change the result (0: one per core)")
        ->transform(wholeFrom(0, 1024));
    command->add_option("--shard", a.shard,
                        "I/N: fly part I of N only, for 'study' to merge (all)");
    addStudyOutput(*command, a.output, "Save flights in this file, and continue from it");
    command->callback([arguments, command, &action] {
        action = [arguments, options = command->config_to_str(true)](const std::stop_token& stop) {
            return SweepRun(*arguments).run(stop, options);
        };
    });
}

} // namespace berg::cli
