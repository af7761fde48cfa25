#include "app/export_run.h"

#include "app/cli/program.h"
#include "core/base/version.h"
#include "widgets/print/export_painter.h"
#include "widgets/theme/language.h"

#include <QApplication>
#include <QLoggingCategory>

#include <clocale>
#include <string_view>

using namespace Qt::StringLiterals;

namespace berg {

bool asksForExport(int argc, char** argv)
{
    return argc > 1 && std::string_view(argv[1]) == "export";
}

int runExport(int argc, char** argv)
{
    const std::stop_token stop = cli::interruptToken();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QLoggingCategory::setFilterRules(u"*.warning=false"_s); // say nothing to who wants a file
    int nameOnly = 1; // Qt's own options, such as -platform, are none of this command
    const QApplication app(nameOnly, argv);
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread yet
    std::setlocale(LC_NUMERIC, "C"); // which the constructor set to the user's; options are in C
    QApplication::setApplicationName(u"bergwatch"_s);
    installLanguage(std::nullopt);
    const auto addCommands = [](CLI::App& commands, cli::Action& action) {
        cli::addExportCommand(commands, action, exportPaint().file);
    };
    return cli::runProgram({.name = "bergwatch",
                            .about = "Bergwatch: exports from the command line",
                            .version = programVersion(),
                            .addCommands = addCommands},
                           argc, argv, stop);
}

} // namespace berg
