#include "app/main_window.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/study_panel.h"

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QScopedValueRollback>
#include <QSessionManager>
#include <QStatusBar>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kMessage_ms = 8000;

std::vector<RecoveryOffer> offersOf(const std::vector<FoundRecovery>& found, const QLocale& locale)
{
    std::vector<RecoveryOffer> offers;
    for (const FoundRecovery& recovery : found)
        offers.push_back(
            {.name = recovery.info.name.isEmpty() ? MainWindow::tr("Untitled") : recovery.info.name,
             .path = recovery.info.originalPath,
             .edited = locale.toString(recovery.info.edited, QLocale::ShortFormat)});
    return offers;
}

} // namespace

void MainWindow::connectSafety()
{
    Autosaver& autosaver = m_workspace.autosaver();
    connect(&autosaver, &Autosaver::autosaved, this, [this](const QDateTime& time) {
        if (m_workspace.document().isClean())
            return; // saved meanwhile
        m_autosaveLabel->setText(tr("Autosaved %1").arg(locale().toString(time, u"HH:mm"_s)));
    });
    connect(&autosaver, &Autosaver::dropped, m_autosaveLabel, &QLabel::clear);
    connect(&autosaver, &Autosaver::failed, this, [this](const QString& report) {
        statusBar()->showMessage(tr("Autosaving failed: %1").arg(report.section(u'\n', 0, 0)),
                                 kMessage_ms);
    });
    connect(&m_workspace.document(), &ScenarioDocument::scenarioChanged, this,
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
}

bool MainWindow::mayEndSession(bool mayAsk)
{
    if (!mayAsk) {
        finishTyping();
        m_workspace.autosaver().keep();
        m_workspace.studyKeeper().keep();
        m_endAgreed = true;
        return true;
    }
    const Interaction::Unsaved study = askAboutStudy();
    // There is no time later on: the program may be killed as soon as this returns.
    m_endAgreed = study != Interaction::Unsaved::Cancel &&
                  (study != Interaction::Unsaved::Save || saveStudyNow()) &&
                  maySettleSolveTimes() && mayLeaveScene(Interaction::FlightEnd::Closing);
    if (m_endAgreed) {
        m_workspace.autosaver().discard();
        m_workspace.studyKeeper().discard();
    }
    return m_endAgreed;
}

/** Logging out closes all windows; whoever uses this one has called it off. */
void MainWindow::followEnd(const QEvent& event)
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

void MainWindow::takeOver(MainWindow& other)
{
    m_carried = std::move(other.m_carried);
    m_study->showAs(*other.m_study);
    m_solveTime->showSpec(other.m_solveTime->spec());
}

bool MainWindow::offerRecoveries()
{
    m_workspace.studyKeeper().lookForAbandoned();
    FoundRecoveries found = m_workspace.autosaver().abandoned();
    for (const QString& path : found.damaged)
        showDamaged(path);
    std::vector<FoundRecovery>& left = found.usable;
    const bool any = !left.empty() || !found.damaged.empty();
    while (!left.empty()) {
        const RecoveryAnswer answer = m_interaction.askRecovery(this, offersOf(left, locale()));
        if (answer.action == RecoveryAnswer::Action::Later)
            break;
        const auto chosen = left.begin() + static_cast<std::ptrdiff_t>(answer.offer);
        if (answer.action == RecoveryAnswer::Action::Restore) {
            if (mayLeaveScene(Interaction::FlightEnd::Other))
                restore(std::move(*chosen));
            break; // the others can be had from the menu, or at the next start
        }
        removeRecovery(chosen->held.files);
        left.erase(chosen);
    }
    return any;
}

void MainWindow::showDamaged(const QString& path)
{
    m_interaction.showError(this,
                            tr("Unsaved work of a program that ended unexpectedly cannot be read. "
                               "It is kept in this file:\n%1")
                                .arg(QDir::toNativeSeparators(path)));
}

void MainWindow::restore(FoundRecovery found)
{
    const QString& path = found.info.originalPath;
    m_workspace.document().restore(found.scenario, path);
    if (!path.isEmpty() && QFileInfo(path).lastModified() > found.info.edited)
        m_workspace.file().setOutdated();
    m_workspace.autosaver().adopt(std::move(found.held));
    statusBar()->showMessage(tr("Restored, not saved yet"), kMessage_ms);
}

/** Somebody else may have changed the file while the user was elsewhere. */
void MainWindow::lookAtFile()
{
    const ScenarioDocument& document = m_workspace.document();
    if (m_asksReload || !isActiveWindow() || !document.isClean() || m_workspace.inFlight() ||
        !m_workspace.file().isChangedOutside())
        return;
    const QFileInfo file(document.filePath());
    if (file.lastModified() == m_carried.reloadRefused)
        return;
    const QScopedValueRollback asking(m_asksReload, true);
    if (m_interaction.askReload(this, file.fileName()))
        openFile(document.filePath());
    else
        m_carried.reloadRefused = file.lastModified();
}

} // namespace berg
