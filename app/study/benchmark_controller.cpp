#include "app/study/benchmark_controller.h"

#include "app/dialogs/interaction.h"
#include "app/files/file_names.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "app/study/study_controller.h"
#include "core/io/results/result_json.h"
#include "core/io/text/atomic_file.h"
#include "core/study/paper_figures.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/workspace/workspace.h"

#include <QFile>
#include <QMainWindow>

using namespace Qt::StringLiterals;

namespace berg {

BenchmarkController::BenchmarkController(WindowContext& context, const Docks& docks)
    : WindowPart(context), m_docks(docks)
{
    connect(panels().study, &StudyPanel::solveTimesRequested, this, [this] {
        if (!workspace().benchmark().isRunning())
            panels().solveTime->showSpec(figure3(benchmarkSolvers()));
        show();
    });
    connect(panels().solveTime, &SolveTimePanel::startRequested, this, [this] {
        if (confirmDiscardBenchmark())
            panels().solveTime->start();
    });
    connect(panels().solveTime, &SolveTimePanel::saveRequested, this, [this] { save(); });
}

void BenchmarkController::show()
{
    m_docks.openFloating(Dock::SolveTime, panels().solveTime->sizeHint());
}

bool BenchmarkController::confirmDiscardBenchmark()
{
    if (!isWorthSaving(settings(), workspace().benchmark().unsaved_s()))
        return true;
    const auto answer =
        interaction().askUnsaved(windowOf(*panels().solveTime), {.name = tr("Solve time")});
    return answer == Interaction::Unsaved::Discard ||
           (answer == Interaction::Unsaved::Save && save());
}

bool BenchmarkController::save()
{
    const QString chosen = interaction().savePath(
        windowOf(*panels().solveTime), u"solve-time.csv"_s, tr("Tables (*.csv);;All files (*)"));
    if (chosen.isEmpty())
        return false;
    const QString path = withExtension(chosen, u"csv"_s);
    BenchmarkRunner& benchmark = workspace().benchmark();
    if (!attempt([&] {
            writeFileAtomically(QFile::encodeName(path).toStdString(),
                                benchmarkCsv(benchmark.rows()));
        }))
        return false;
    benchmark.noteSaved();
    showMessage(tr("Saved %1").arg(path), kLongMessage_ms);
    return true;
}

} // namespace berg
