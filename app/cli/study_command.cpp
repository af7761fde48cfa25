#include "app/cli/commands.h"
#include "app/cli/study_file.h"
#include "app/cli/study_output.h"
#include "core/io/atomic_file.h"
#include "core/io/study_json.h"
#include "core/io/study_report.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace berg::cli {

namespace {

struct StudyArguments
{
    std::vector<std::string> files;
    std::string mergedFile;
    bool force = false;
    StudyOutput output;
};

/** `part` added to `whole`; errors name the file it came from. */
Study added(Study whole, Study part, const std::string& file)
{
    std::vector<Study> both;
    both.push_back(std::move(whole));
    both.push_back(std::move(part));
    try {
        return merge(std::move(both));
    } catch (const Error& error) {
        throw Error(error.code(), file, error.issues());
    }
}

/** Of a study file, or of the report that holds one. */
Study read(const std::string& file)
{
    const std::string text = readFile(file);
    return studyFromJson(isReport(text) ? studyOfReport(text, file) : text, file);
}

Study merged(const std::vector<std::string>& files, const std::stop_token& stop)
{
    Study whole = read(files.front());
    for (std::size_t i = 1; i < files.size(); ++i) {
        if (stop.stop_requested())
            throw Interrupted{};
        whole = added(std::move(whole), read(files[i]), files[i]);
    }
    return whole;
}

int showStudy(const StudyArguments& arguments, const std::stop_token& stop)
{
    Study study = merged(arguments.files, stop);
    static_cast<void>(referenceOf(study.spec, arguments.output));
    StudyFile file(arguments.mergedFile, arguments.force);
    if (file.isKept()) {
        study = added(std::move(study), file.open(study.spec), arguments.mergedFile);
        file.save(study);
    }
    writeResults(study, arguments.output);
    return kDone;
}

} // namespace

void addStudyCommand(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("study", "Merge the files of sweeps and show what came of them");
    const auto arguments = std::make_shared<StudyArguments>();
    command
        ->add_option("FILE", arguments->files, "Files written by 'sweep --study', or their reports")
        ->required();
    command->add_option("--study", arguments->mergedFile, "Write them as one file");
    command->add_flag("--force", arguments->force, "Replace a --study file of another study");
    addStudyOutput(*command, arguments->output);
    command->callback([arguments, &action] {
        action = [arguments](const std::stop_token& stop) { return showStudy(*arguments, stop); };
    });
}

} // namespace berg::cli
