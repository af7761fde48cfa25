#include "app/window/unsaved_work_guard.h"

#include "app/files/result_files.h"
#include "app/files/scenario_files.h"
#include "app/layout/panels.h"
#include "app/layout/run_with_progress.h"
#include "app/layout/status_line.h"
#include "app/study/benchmark_controller.h"
#include "app/study/study_controller.h"
#include "widgets/tasks/work_failure.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QScopedValueRollback>
#include <QSessionManager>
#include <QTimer>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

QString nameOf(const FoundRecovery& recovery)
{
    return recovery.info.name.isEmpty() ? UnsavedWorkGuard::tr("Untitled") : recovery.info.name;
}

std::vector<RecoveryOffer> offersOf(const std::vector<FoundRecovery>& found, const QLocale& locale)
{
    std::vector<RecoveryOffer> offers;
    for (const FoundRecovery& recovery : found)
        offers.push_back({.name = recovery.run
                                      ? UnsavedWorkGuard::tr("%1, in flight").arg(nameOf(recovery))
                                      : nameOf(recovery),
                          .path = recovery.info.originalPath,
                          .edited = locale.toString(recovery.info.edited, QLocale::ShortFormat)});
    return offers;
}

} // namespace

UnsavedWorkGuard::UnsavedWorkGuard(WindowContext& context, const CloseGuards& gates,
                                   StatusLine& status)
    : WindowPart(context), m_gates(gates), m_status(status)
{
    connectAutosaver();
    connect(&workspace().studyAutosaver(), &StudyAutosaver::damaged, this,
            &UnsavedWorkGuard::showDamaged);
    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            [this] { m_endAgreed = false; });
    connect(
        qApp, &QGuiApplication::commitDataRequest, this,
        [this](QSessionManager& manager) {
            const bool mayAsk = manager.allowsInteraction();
            if (!mayEndSession(mayAsk))
                manager.cancel();
            if (mayAsk)
                manager.release();
        },
        Qt::DirectConnection);
    qApp->installEventFilter(this);
}

void UnsavedWorkGuard::connectAutosaver()
{
    const Autosaver& autosaver = workspace().autosaver();
    connect(&autosaver, &Autosaver::autosaved, this, [this](const QDateTime& time) {
        if (workspace().document().isClean())
            return; // saved meanwhile
        m_status.showAutosaved(tr("Autosaved %1").arg(locale().toString(time, u"HH:mm"_s)));
    });
    connect(&autosaver, &Autosaver::dropped, this, [this] { m_status.showAutosaved({}); });
    connect(&autosaver, &Autosaver::failed, this, [this](const QString& report) {
        showMessage(tr("Autosaving failed: %1").arg(report.section(u'\n', 0, 0)), kLongMessage_ms);
    });
}

bool UnsavedWorkGuard::eventFilter(QObject* watched, QEvent* event)
{
    followEnd(*event);
    if (watched == &window() && event->type() == QEvent::ActivationChange &&
        window().isActiveWindow())
        QTimer::singleShot(0, this, &UnsavedWorkGuard::checkFile);
    return WindowPart::eventFilter(watched, event);
}

bool UnsavedWorkGuard::mayClose()
{
    if (m_ends)
        return true;
    // The study first: it may take a while to be saved, and then all this is asked again.
    if (!m_gates.study.maySettleStudy([](StudyController& desk) { desk.closeWindow(); }) ||
        !m_gates.solveTimes.confirmDiscardBenchmark() || !confirmDiscardScenario())
        return false;
    workspace().autosaver().discard();
    return true;
}

/** For good: what was flown is lost as well. Of the list of runs only the one shown is asked about:
 * the others were left when another scenario was opened or the flight was stopped. */
bool UnsavedWorkGuard::confirmDiscardScenario()
{
    if (!m_gates.files.maySettleChanges())
        return false;
    if (!workspace().hasUnsavedRun())
        return true;
    const auto answer = interaction().askUnsavedRun(&window(), workspace().isMidFlight());
    return answer == Interaction::Unsaved::Discard ||
           (answer == Interaction::Unsaved::Save && m_gates.results.saveRunNow());
}

bool UnsavedWorkGuard::mayEndSession(bool mayAsk)
{
    if (!mayAsk) {
        panels().finishTyping();
        workspace().autosaver().keep();
        workspace().studyAutosaver().keep();
        m_endAgreed = true;
        return true;
    }
    const Interaction::Unsaved study = m_gates.study.askAboutStudy();
    // There is no time later on: the program may be killed as soon as this returns.
    m_endAgreed = study != Interaction::Unsaved::Cancel &&
                  (study != Interaction::Unsaved::Save || m_gates.study.saveStudyNow()) &&
                  m_gates.solveTimes.confirmDiscardBenchmark() && confirmDiscardScenario();
    if (m_endAgreed) {
        workspace().autosaver().discard();
        workspace().studyAutosaver().discard();
    }
    return m_endAgreed;
}

/** Logging out closes all windows; whoever uses this one has called it off. */
void UnsavedWorkGuard::followEnd(const QEvent& event)
{
    if (!m_endAgreed)
        return;
    if (event.type() == QEvent::Quit) {
        m_ends = true;
        QTimer::singleShot(0, this, [this] { m_ends = false; }); // unless another one objects
    } else if (event.type() == QEvent::KeyPress || event.type() == QEvent::MouseButtonPress) {
        m_endAgreed = false;
    }
}

bool UnsavedWorkGuard::offerRecoveries()
{
    workspace().studyAutosaver().findAbandoned();
    FoundRecoveries found;
    std::optional<WorkFailure> failure; // such as memory for a huge run
    runWithProgress(interaction(), &window(), tr("Reading unsaved work"), [&] {
        failure = failureOf([&] { found = workspace().autosaver().abandoned(); });
    });
    if (failure) {
        interaction().showError(&window(), failure->report);
        return true;
    }
    for (const QString& path : found.damaged)
        showDamaged(path);
    std::vector<FoundRecovery>& left = found.usable;
    const bool any = !left.empty() || !found.damaged.empty();
    while (!left.empty()) {
        const RecoveryAnswer answer =
            interaction().askRecovery(&window(), offersOf(left, locale()));
        if (answer.action == RecoveryAnswer::Action::Later)
            break;
        const auto chosen = left.begin() + static_cast<std::ptrdiff_t>(answer.offer);
        if (answer.action == RecoveryAnswer::Action::Restore) {
            if (m_gates.files.confirmDiscardScenario())
                restore(std::move(*chosen));
            break; // the others can be had from the menu, or at the next start
        }
        removeRecovery(chosen->held.files);
        left.erase(chosen);
    }
    return any;
}

void UnsavedWorkGuard::showDamaged(const QString& path)
{
    interaction().showError(&window(),
                            tr("Unsaved work of a program that ended unexpectedly cannot be read. "
                               "It is kept in this file:\n%1")
                                .arg(QDir::toNativeSeparators(path)));
}

void UnsavedWorkGuard::restore(FoundRecovery found)
{
    const QFileInfo file(found.info.originalPath);
    const bool isOutdated = !file.filePath().isEmpty() && file.lastModified() > found.info.edited;
    workspace().restore(std::move(found));
    if (isOutdated)
        workspace().file().setOutdated();
    showMessage(tr("Restored, not saved yet"), kLongMessage_ms);
}

/** Somebody else may have changed the file while the user was elsewhere. */
void UnsavedWorkGuard::checkFile()
{
    const ScenarioDocument& document = workspace().document();
    if (m_asksReload || !window().isActiveWindow() || !document.isClean() ||
        workspace().inFlight() || !workspace().file().isChangedOutside())
        return;
    const QFileInfo file(document.filePath());
    if (file.lastModified() == m_reloadRefused)
        return;
    const QScopedValueRollback asking(m_asksReload, true);
    if (interaction().askReload(&window(), file.fileName()))
        m_gates.files.openFile(document.filePath());
    else
        m_reloadRefused = file.lastModified();
}

} // namespace berg
