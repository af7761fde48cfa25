#include "app/cli/console.h"
#include "app/cli/options.h"
#include "app/cli/study/study_file.h"
#include "app/cli/study/study_output.h"
#include "core/io/study/study_json.h"
#include "core/io/study/study_report.h"
#include "core/io/text/atomic_file.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace berg::cli {

namespace {

struct StudyArguments
{
    std::vector<std::string> files;
    StudyOutput output;
};

/** `part` added to `whole`; errors name the file it came from. */
Study added(Study whole, Study part, const std::string& file)
{
    std::vector<Study> both;
    both.push_back(std::move(whole));
    both.push_back(std::move(part));
    return naming(file, [&] { return merge(std::move(both)); });
}

Study merged(const std::vector<std::string>& files)
{
    Study whole = loadStudy(files.front());
    for (std::size_t i = 1; i < files.size(); ++i)
        whole = added(std::move(whole), loadStudy(files[i]), files[i]);
    return whole;
}

int showStudy(const StudyArguments& arguments, const std::stop_token& /*stop*/)
{
    const StudyOutput& output = arguments.output;
    checkFiles(filesOf(output, arguments.files));
    StudyFile file(output.studyFile, output.replaceStudy);
    const Study study = reading([&] {
        Study whole = merged(arguments.files);
        static_cast<void>(referenceOf(whole.spec, output));
        return file.isStored() ? added(whole, file.open(whole.spec), output.studyFile) : whole;
    });
    writeResults(study, output, [&] { file.save(study); });
    return kDone;
}

} // namespace

void addStudyCommand(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("study", "Merge the files of sweeps and show the results");
    StudyArguments& a = argumentsOf(*command, action, showStudy);
    command->add_option("FILE", a.files, "Files written by 'sweep --study', or their reports")
        ->required();
    addStudyOutput(*command, a.output, "Write them as one file");
}

} // namespace berg::cli
