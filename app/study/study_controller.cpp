#include "app/study/study_controller.h"

#include "app/files/file_names.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "core/io/study/study_json.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/panels/study/study_results.h"
#include "widgets/workspace/workspace.h"

#include <QFile>
#include <QMainWindow>
#include <QSettings>

#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kStudyWorthKey = "study/worthSaving_s"; ///< asked about from then on

QString studyFilter()
{
    return StudyController::tr("Studies (*.bergstudy);;All files (*)");
}

} // namespace

StudyController::StudyController(WindowContext& context, const Docks& docks)
    : WindowPart(context), m_docks(docks)
{
    connectPanel();
    connectFiles();
    connectKeeper();
    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            [this] { panels().study->setScenario(workspace().document().scenario()); });
    panels().study->setScenario(workspace().document().scenario());
}

void StudyController::connectPanel()
{
    const StudyPanel* panel = panels().study;
    connect(panel, &StudyPanel::startRequested, this, [this](const StudySpec& spec, bool compares) {
        replaceStudy([spec, compares](StudyController& desk) {
            desk.panels().study->start(spec, compares);
        });
    });
    const StudyResults* results = &panel->results();
    connect(results, &StudyResults::openRequested, this, [this] {
        const QString path = interaction().openPath(
            windowOf(*panels().study),
            tr("Studies and their reports (*.bergstudy *.json *.html);;All files (*)"));
        if (!path.isEmpty())
            workspace().studyFiles().open(path);
    });
    connect(results, &StudyResults::saveRequested, this, [this] { saveStudy(); });
    connect(results, &StudyResults::reportRequested, this, [this] {
        const QString path = studyPath(u"html"_s, tr("Reports (*.html);;All files (*)"));
        if (!path.isEmpty())
            workspace().studyFiles().writeReport(workspace().study().result(),
                                                 workspace().study().elapsed_s(), path);
    });
    connect(results, &StudyResults::tableRequested, this, [this] {
        const QString path = studyPath(u"csv"_s, tr("Tables (*.csv);;All files (*)"));
        if (!path.isEmpty())
            workspace().studyFiles().writeTable(workspace().study().result(), path);
    });
    connect(results, &StudyResults::pictureRequested, this, &StudyController::saveStudyPicture);
}

void StudyController::connectFiles()
{
    const StudyFiles& files = workspace().studyFiles();
    const auto noteSaved = [this](const QString& path) {
        panels().study->showNote(tr("Saved %1").arg(path));
    };
    connect(&files, &StudyFiles::opened, this, [this](const std::shared_ptr<const Study>& study) {
        replaceStudy([study](StudyController& desk) {
            desk.panels().study->showNote({}); // of the one before
            desk.workspace().study().show(*study);
            desk.showStudy();
        });
    });
    connect(&files, &StudyFiles::written, this, noteSaved);
    connect(&files, &StudyFiles::saved, this, [this, noteSaved](const QString& path) {
        noteSaved(path);
        if (const AfterStudy then = std::exchange(m_afterSaved, {}))
            then(*this);
    });
    connect(&files, &StudyFiles::failed, this, [this](const QString& report) {
        m_afterSaved = {};
        interaction().showError(windowOf(*panels().study), report);
    });
}

void StudyController::connectKeeper()
{
    const StudyAutosaver& keeper = workspace().studyAutosaver();
    connect(&keeper, &StudyAutosaver::found, this,
            [this](const std::shared_ptr<const Study>& study) {
                workspace().study().restore(*study);
                showStudy();
                panels().study->showNote(
                    tr("Bergwatch ended unexpectedly. This unsaved study was kept. "
                       "Save it, or fly the rest."));
            });
    connect(&keeper, &StudyAutosaver::failed, this, [this](const QString& report) {
        showMessage(tr("Autosaving failed: %1").arg(report.section(u'\n', 0, 0)), kLongMessage_ms);
    });
}

/** Returns the path that the user chose; empty if cancelled. */
QString StudyController::studyPath(const QString& extension, const QString& filter)
{
    const QString name =
        fileNameOf(QString::fromStdString(workspace().study().result()->study.spec.name));
    const QString path =
        interaction().savePath(windowOf(*panels().study), name + u'.' + extension, filter);
    return path.isEmpty() ? path : withExtension(path, extension);
}

bool StudyController::saveStudy()
{
    const QString path = studyPath(u"bergstudy"_s, studyFilter());
    if (path.isEmpty())
        return false;
    const StudyRunner& study = workspace().study();
    workspace().studyFiles().save(study.result(), study.savePoint(), path);
    return true;
}

bool StudyController::saveStudyNow()
{
    const QString path = studyPath(u"bergstudy"_s, studyFilter());
    if (path.isEmpty())
        return false;
    StudyRunner& study = workspace().study();
    return attempt([&] {
        berg::saveStudy(study.result()->study, QFile::encodeName(path).toStdString());
        study.noteSaved(study.savePoint());
    });
}

Interaction::Unsaved StudyController::askAboutStudy()
{
    const StudyRunner& study = workspace().study();
    if (!study.result() || !isWorthSaving(settings(), study.unsaved_s()))
        return Interaction::Unsaved::Discard;
    const QString name = QString::fromStdString(study.result()->study.spec.name);
    return interaction().askUnsaved(windowOf(*panels().study), {.name = tr("Study: %1").arg(name)});
}

bool StudyController::maySettleStudy(AfterStudy then)
{
    const Interaction::Unsaved answer = askAboutStudy();
    if (answer == Interaction::Unsaved::Save && saveStudy())
        m_afterSaved = std::move(then);
    return answer == Interaction::Unsaved::Discard;
}

void StudyController::replaceStudy(const AfterStudy& replace)
{
    if (maySettleStudy(replace))
        replace(*this);
}

void StudyController::saveStudyPicture()
{
    const QString path =
        interaction().savePath(windowOf(*panels().study), panels().study->results().pictureName(),
                               ChartPanel::pictureFilters().join(u";;"_s));
    if (path.isEmpty())
        return;
    attempt([&] {
        panels().study->results().writePicture(withExtension(path, u"png"_s));
        panels().study->showNote(tr("Saved %1").arg(path));
    });
}

void StudyController::showStudy()
{
    m_docks.openFloating(Dock::Study, panels().study->sizeHint());
}

void StudyController::closeWindow()
{
    window().close();
}

void StudyController::takeOver(StudyController& other)
{
    m_afterSaved = std::move(other.m_afterSaved);
    panels().study->showAs(*other.panels().study);
}

bool isWorthSaving(const QSettings& settings, double unsaved_s)
{
    return unsaved_s > 0 && unsaved_s >= settings.value(kStudyWorthKey, 60).toDouble();
}

} // namespace berg
