#pragma once

#include "app/dialogs/interaction.h"
#include "app/window/main_window_host.h"
#include "core/base/random.h"
#include "core/base/solving_guard.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/study/study_json.h"
#include "tests/support/files/file_texts.h"
#include "tests/support/window/study_builder.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/language.h"
#include "widgets/workspace/workspace.h"

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include <future>

namespace berg::test {

using namespace Qt::StringLiterals;

/** The real dialogs except those for files, in which random choices could overwrite any file. */
class MonkeyInteraction final : public DialogInteraction
{
public:
    MonkeyInteraction(QString folder, std::uint64_t seed)
        : m_folder(std::move(folder)), m_random(seed, 5)
    {
    }

    [[nodiscard]] QString openPath(QWidget*, const QString&) override
    {
        QTest::qWait(static_cast<int>(m_random.below(20))); // as long as the dialog is open
        return m_random.below(4) == 0 ? QString() : anyFile();
    }
    [[nodiscard]] QString savePath(QWidget*, const QString&, const QString&) override
    {
        QTest::qWait(static_cast<int>(m_random.below(20)));
        if (m_random.below(4) == 0)
            return {};
        return QDir(m_folder).filePath(u"saved-%1"_s.arg(m_random.below(3)));
    }
    /** Returns a file to open, sometimes one that cannot be opened. */
    [[nodiscard]] QString anyFile()
    {
        const QDir folder(m_folder);
        const QStringList names = folder.entryList(QDir::Files);
        const auto count = static_cast<std::uint64_t>(names.size());
        return folder.filePath(names[static_cast<qsizetype>(m_random.below(count))]);
    }

private:
    QString m_folder;
    Random m_random;
};

/** The real window with real dialogs, and a folder with files of every type. */
class MonkeyWindow
{
public:
    MonkeyWindow(const Scenario& scenario, std::uint64_t seed) : interaction(files(), seed)
    {
        installLanguage(u"en"_s);
        makeFiles(scenario);
        settings.setValue("export/folder", files());
        settings.setValue("start/tourSeen", true);
        workspace.file().setLockFolder(folder.filePath(u"locks"_s));
        workspace.autosaver().start(folder.filePath(u"recovery"_s),
                                    {.pause_ms = 50, .longest_ms = 200});
        workspace.document().reset(scenario);
        m_holder = std::make_unique<MainWindowHost>(workspace, interaction, settings);
        window().resize(1280, 800);
        window().show();
        window().activateWindow();
        if (!QTest::qWaitForWindowActive(&window()))
            qFatal("the window does not come up");
    }

    QTemporaryDir folder;
    QSettings settings{folder.filePath(u"settings.ini"_s), QSettings::IniFormat};
    MonkeyInteraction interaction;
    Workspace workspace;

    /** Returns the window, which is another one after each change of language or units. */
    [[nodiscard]] MainWindow& window() { return m_holder->window(); }
    [[nodiscard]] MapView& map() { return window().mapView(); }
    [[nodiscard]] ScenarioDocument& document() { return workspace.document(); }
    [[nodiscard]] const Scenario& scenario() { return workspace.document().scenario(); }

    /** Waits until the mission of the newest command is shown and planned. */
    [[nodiscard]] bool untilAnswered(int patience_ms)
    {
        return QTest::qWaitFor(
            [this] {
                const MissionSnapshot& now = workspace.record().now;
                return now.generation == workspace.runner().generation() &&
                       now.phase != RunPhase::Planning;
            },
            patience_ms);
    }

private:
    [[nodiscard]] QString files() const { return folder.filePath(u"files"_s); }

    void makeFiles(const Scenario& scenario) const
    {
        QDir().mkpath(files());
        const QDir to(files());
        const QDir examples(QStringLiteral(BERG_SOURCE_DIR "/resources/scenarios"));
        for (const QString& name : {u"disko-bay-4.berg"_s, u"svalbard-two-uavs.berg"_s,
                                    u"twillingate-clusters.berg"_s, u"hibernia-asset.berg"_s})
            QFile::copy(examples.filePath(name), to.filePath(name));
        for (const QString& path :
             {u"import/table.csv"_s, u"import/scene.kml"_s, u"import/scene.geojson"_s,
              u"broken/text/binary.berg"_s, u"broken/scene/geofence-without-area.berg"_s})
            QFile::copy(QDir(QStringLiteral(BERG_TEST_DATA)).filePath(path),
                        to.filePath(QFileInfo(path).fileName()));
        const auto native = [&](const QString& name) { return to.filePath(name).toStdString(); };
        saveScenario(scenario, native(u"start.berg"_s));
        std::async(std::launch::async,
                   [&] { // on another thread than the window's
                       Mission mission(quickScenario());
                       mission.advance(60);
                       saveRun(runOf(mission), native(u"flown.bergrun"_s));
                       Study study{.spec = quickStudy(2), .outcomes = {}};
                       fly(study);
                       saveStudy(study, native(u"flown.bergstudy"_s));
                   })
            .get();
    }

    std::unique_ptr<MainWindowHost> m_holder;
    NoBlockingScope m_guard;
};

} // namespace berg::test
