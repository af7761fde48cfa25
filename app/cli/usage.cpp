#include "app/cli/usage.h"

#include "core/io/text/read_budget.h"
#include "core/plan/solve/names.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <span>
#include <sstream>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace berg::cli {

namespace {

constexpr std::size_t kHelpColumn = 34; ///< where explanations begin
constexpr std::size_t kLeastWidth = 60; ///< narrower than this, lines are left to the terminal
constexpr std::size_t kUsualWidth = 80;
constexpr std::size_t kMostWidth = 120; ///< longer lines are hard to read
constexpr char kBetween = '\x1F';       ///< the English and the other words of a fault

/** Insertions, deletions and changes of a character from one word to the other. */
std::size_t editDistance(const std::string& from, const std::string& to)
{
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t changed = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

/** Returns the known word nearest to `word`; empty if none is near. */
std::string nearestOf(const std::string& word, const std::vector<std::string>& known)
{
    const auto nearest = std::ranges::min_element(
        known, {}, [&word](const std::string& one) { return editDistance(word, one); });
    if (nearest == known.end() ||
        editDistance(word, *nearest) > std::max<std::size_t>(1, word.size() / 3))
        return {};
    return *nearest;
}

std::vector<const CLI::App*> commandsOf(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App*) { return true; });
}

Sentence unknownOption(const std::string& name, const std::vector<std::string>& known)
{
    constexpr std::size_t kShort = 2; // all of those are near
    const std::string nearest = name.size() > kShort ? nearestOf(name, known) : std::string();
    if (nearest.empty())
        return sentence(QT_TRANSLATE_NOOP("CommandLine", "there is no option '%1'"), {name});
    return sentence(QT_TRANSLATE_NOOP("CommandLine", "there is no option '%1'; did you mean '%2'?"),
                    {name, nearest});
}

/** "--tau", "-t", ... */
std::vector<std::string> optionsOf(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
        for (const std::string& name : option->get_snames())
            names.push_back('-' + name);
    }
    return names;
}

const CLI::App* chosen(const CLI::App& app, const std::vector<std::string>& words)
{
    const std::vector<const CLI::App*> commands = commandsOf(app);
    const auto found = std::ranges::find_if(commands, [&words](const CLI::App* command) {
        return !words.empty() && command->get_name() == words.front();
    });
    return found == commands.end() ? nullptr : *found;
}

/** One line under the column of its explanation. */
std::string wrappedLine(const std::string& line, std::size_t width)
{
    std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    if (line.size() > kHelpColumn && line[kHelpColumn - 1] == ' ' && line.starts_with("  "))
        indent = kHelpColumn;
    std::string text;
    std::string rest = line;
    while (rest.size() > width) {
        const std::size_t space = rest.rfind(' ', width);
        if (space == std::string::npos || space <= indent)
            break; // a word as long as the line
        text += rest.substr(0, space) + '\n';
        rest = std::string(indent, ' ') + rest.substr(space + 1);
    }
    return text + rest;
}

/** Each line with `before` in front. */
std::string indented(std::string_view lines, const std::string& before)
{
    std::istringstream in{std::string(lines)};
    std::string text;
    for (std::string line; std::getline(in, line);)
        text.append(text.empty() ? "" : "\n").append(before).append(line);
    return text;
}

} // namespace

std::vector<std::string> wordsOf(int argc, const char* const* argv)
{
    const std::span all(argv, static_cast<std::size_t>(argc));
    std::vector<std::string> words(all.begin() + (argc > 0 ? 1 : 0), all.end());
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        words.resize(std::min<std::size_t>(words.size(), 1));
        words.emplace_back("--help");
    }
    return words;
}

std::optional<Sentence> unknownCommand(const CLI::App& app, const std::vector<std::string>& words)
{
    if (words.empty() || words.front().starts_with('-') || chosen(app, words) != nullptr)
        return std::nullopt;
    std::vector<std::string> names;
    for (const CLI::App* one : commandsOf(app))
        names.push_back(one->get_name());
    const std::string nearest = nearestOf(words.front(), names);
    if (nearest.empty())
        return sentence(QT_TRANSLATE_NOOP("CommandLine", "there is no command '%1'"),
                        {words.front()});
    return sentence(
        QT_TRANSLATE_NOOP("CommandLine", "there is no command '%1'; did you mean '%2'?"),
        {words.front(), nearest});
}

std::optional<Sentence> unknownWord(const CLI::App& app, const std::vector<std::string>& words)
{
    if (words.empty())
        return sentence(QT_TRANSLATE_NOOP("CommandLine", "a command is required"));
    const CLI::App* command = chosen(app, words);
    if (command == nullptr)
        return words.front().starts_with('-') ? unknownOption(words.front(), optionsOf(app))
                                              : unknownCommand(app, words);
    const auto exists = [command](const std::string& name) {
        return command->get_option_no_throw(name) != nullptr;
    };
    for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
        const std::string name = words[i].substr(0, words[i].find('='));
        const bool isLong = name.starts_with("--");
        const bool isShort = name.size() > 1 && name[0] == '-' &&
                             std::isalpha(static_cast<unsigned char>(name[1])) != 0;
        if ((isLong && !exists(name)) || (isShort && !exists(name.substr(0, 2))))
            return unknownOption(name, optionsOf(*command));
        if (isShort && exists('-' + name)) // -tau would be -t with the value au
            return unknownOption(name, {'-' + name});
    }
    return std::nullopt;
}

void readDashFromStandardInput(CLI::App& app)
{
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options())
            if ((option->get_positional() && option->get_name() != "SHELL") ||
                option->check_lname("into"))
                option->transform(CLI::Validator(
                    [](std::string& file) {
                        if (file == "-")
                            file = "/dev/stdin";
                        return std::string();
                    },
                    ""));
}

std::string emptyOption(const CLI::App& app)
{
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            if (option->get_expected_max() > 0 && std::ranges::count(option->results(), "") > 0)
                return option->get_name();
    return {};
}

std::string inOne(const Sentence& fault)
{
    return fault.english + kBetween + fault.said;
}

Sentence plainWords(const CLI::ParseError& error)
{
    std::string text = error.what();
    const std::string subject = text.substr(0, text.find(": "));
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return sentence(text.ends_with("missing")
                            ? QT_TRANSLATE_NOOP("CommandLine", "%1 needs a value")
                            : QT_TRANSLATE_NOOP("CommandLine", "%1 is given more than once"),
                        {subject});
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
        return sentence(QT_TRANSLATE_NOOP("CommandLine", "not expected: %1"),
                        {text.substr(subject.size() + 2)});
    constexpr std::string_view kRequired = " is required";
    if (text.ends_with(kRequired))
        return sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 is required"),
                        {text.substr(0, text.size() - kRequired.size())});
    constexpr std::string_view kExcludes = " excludes ";
    if (const std::size_t at = text.find(kExcludes); at != std::string::npos)
        return sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"),
                        {text.substr(0, at), text.substr(at + kExcludes.size())});
    if (const std::size_t between = text.rfind(kBetween); between != std::string::npos)
        return {.english = text.substr(0, between),
                .said = subject + ": " + text.substr(between + 1)};
    return {.english = text, .said = text};
}

std::string commandOf(const CLI::App& app, const std::vector<std::string>& words)
{
    const CLI::App* command = chosen(app, words);
    return command == nullptr ? app.get_name() : app.get_name() + ' ' + command->get_name();
}

std::string wrapped(const std::string& help, std::size_t width)
{
    if (width < kLeastWidth)
        return help;
    std::string text;
    std::size_t begin = 0;
    while (begin < help.size()) {
        const std::size_t end = std::min(help.find('\n', begin), help.size());
        text += wrappedLine(help.substr(begin, end - begin), width) + '\n';
        begin = end + 1;
    }
    return text;
}

std::size_t terminalWidth()
{
    winsize size = {};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return std::min<std::size_t>(size.ws_col, kMostWidth);
    const char* const given =
        std::getenv("COLUMNS"); // NOLINT(concurrency-mt-unsafe): nobody sets it
    const std::string_view text = given == nullptr ? "" : given;
    std::size_t columns = kUsualWidth;
    std::from_chars(text.data(), text.data() + text.size(), columns);
    return std::min(columns, kMostWidth);
}

void addExamples(CLI::App& app)
{
    static constexpr std::pair<std::string_view, std::string_view> kExamples[] = {
        {"solve", "solve problem.json --gap 0.01\n"
                  "solve berlin52.tsp --backend exact --criterion latency --return"},
        {"plan", "plan field.berg --tau 1 --json\nplan field.berg --policy latency --certificate "
                 "proof.json"},
        {"curve", "curve field.berg --tau-max 5 --output curve.csv"},
        {"simulate", "simulate field.berg --duration 3600 --output out\nsimulate out/run.bergrun"},
        {"sweep", "sweep field.berg --tau 0:4:0.5 --runs 20 --study field.bergstudy\n"
                  "sweep --random 50 --tau 1 --policies visitation,latency,coverage"},
        {"study", "study part-1.bergstudy part-2.bergstudy --report report.html"},
        {"benchmark", "benchmark --sizes 8,12,20 --repeat 5"},
        {"export", "export field.berg --output mission.plan\n"
                   "export run.bergrun --format brief --output brief.pdf"},
        {"validate", "validate *.berg"},
        {"import", "import sightings.csv --output field.berg --map id=name"},
        {"forecast", "forecast locationforecast.json oceanforecast.json --since 2026-05-01T12:00Z"},
        {"drift", "drift --length 120 --wind-speed 10 --wind-from 270 --current-speed 0.3 "
                  "--current-to 0\n"
                  "drift --size medium --forecast locationforecast.json --forecast "
                  "oceanforecast.json\n"
                  "drift --size medium --current-speed 0.2 --current-to 180 --track beacon.csv"},
        {"vehicle", "vehicle field.berg --link udpout:127.0.0.1:14550 --fly\n"
                    "vehicle field.berg --link udp:14550 --autopilot px4 --loss 5 --delay 1.5"},
        {"listen", "listen --link udp:14550 --tlog flight.tlog --duration 600\n"
                   "listen --link serial:/dev/ttyUSB0:57600"},
        {"completion", "completion bash > bergwatch-cli.bash"}};
    app.footer(
        "Files:\n  -" + std::string(kHelpColumn - 3, ' ') +
        "Instead of a file: standard input or output. Not for --study or a folder\n\n"
        "Environment:\n  " +
        std::string(kReadLimitsVariable) + "=N" + std::string(kHelpColumn - 25, ' ') +
        "Multiplies every limit of reading (64 MiB, ten times a file and 50 MB of memory, ten "
        "million values, a million rows) by N, from 1 to 1000. The limits of the contents of a "
        "scenario or problem and the million missions of a study are fixed");
    for (CLI::App* command : app.get_subcommands({}))
        for (const auto& [name, lines] : kExamples)
            if (command->get_name() == name)
                command->footer("Examples:\n" + indented(lines, "  " + app.get_name() + ' '));
}

std::string bashCompletion(const CLI::App& app)
{
    std::vector<std::string> names{"help"};
    std::string cases;
    for (const CLI::App* command : commandsOf(app)) {
        names.push_back(command->get_name());
        cases += "        " + command->get_name() + ") words=\"" +
                 joined(optionsOf(*command), " ") + "\" ;;\n";
    }
    return "# Completion of " + app.get_name() +
           " for bash.\n"
           "_bergwatch_cli() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} words=\"\"\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ] || [ \"${COMP_WORDS[1]}\" = help ]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -W \"" +
           joined(names, " ") +
           " --help --version\" -- \"$current\")\n"
           "        return\n"
           "    fi\n"
           "    case ${COMP_WORDS[1]} in\n" +
           cases +
           "    esac\n"
           "    if [[ $current == -* ]]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
           "    else\n"
           "        compopt -o filenames\n"
           "        mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
           "    fi\n"
           "}\n"
           "complete -F _bergwatch_cli " +
           app.get_name() + '\n';
}

} // namespace berg::cli
