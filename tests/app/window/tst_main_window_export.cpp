#include "core/io/export/formats.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/ogr2ogr.h"
#include "core/presets/presets.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/print/export_painter.h"

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QStatusBar>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario three()
{
    Scenario scenario = randomScenario(31, {.icebergs = 3});
    scenario.startUtc = "2026-05-01T12:00:00Z"; // sightings need dates
    return scenario;
}

ExportRequest requestFor(const char* format, const QString& path)
{
    ExportRequest request;
    request.formatId = format;
    request.path = path;
    return request;
}

} // namespace

/** Plans and runs as files of other programs. */
class TestMainWindowExport : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Formats of a flight are disabled before take-off. */
    void logIsOfAFlight()
    {
        WindowFixture w(randomScenario(1, {.icebergs = 4}));
        QVERIFY(!w.action(u"logAction"_s).isEnabled());
        w.workspace.stepTicks(1);
        QTRY_VERIFY(w.action(u"logAction"_s).isEnabled());
    }

    void exportsWhatTheTableWrites_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<bool>("flown");
        for (const ExportFormat& format : exportFormats())
            for (const bool flown : {false, true}) {
                if ((format.holds.flownOnly && !flown) ||
                    (format.holds.gis && ogr2ogrPath().empty()))
                    continue;
                const QString id =
                    QString::fromLatin1(format.id.data(), qsizetype(format.id.size()));
                QTest::addRow("%s, %s", qPrintable(id), flown ? "flown" : "plan") << id << flown;
            }
    }

    void exportsWhatTheTableWrites()
    {
        QFETCH(QString, format);
        QFETCH(bool, flown);
        const Scenario scenario = three();
        WindowFixture w(scenario);
        if (flown) {
            for (int i = 0; i < 40; ++i)
                w.trigger(u"stepAction"_s);
            QVERIFY(w.until([&] { return w.record().now.time_s > 39.95; }));
        }
        QVERIFY(w.until([&] { return w.workspace.predicted().has_value(); }));
        const std::optional<ZetaPrediction> predicted = w.workspace.predicted();
        const QString path = w.file(u"plan.out"_s);
        w.interaction.exportChoice = requestFor(qPrintable(format), path);
        w.trigger(u"exportAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(path); }));
        QCOMPARE(w.interaction.offers.size(), 1U);
        QCOMPARE(w.interaction.offers.front().flown, flown);
        const std::string expected = test::elsewhere([&] {
            Mission mission(scenario);
            mission.advance(flown ? 40 : 0);
            const Plan plan = planFromStart(scenario);
            const ExportContent content = exportContent({.scenario = scenario,
                                                         .plan = plan,
                                                         .mission = flown ? &mission : nullptr,
                                                         .predicted = predicted});
            return exportFiles(*findExportFormat(format.toStdString()), content, {},
                               exportPaint().file)
                .front()
                .content;
        });
        QVERIFY(readFile(path.toStdString()) == expected);
        QVERIFY(w.interaction.errors.isEmpty());
    }

    void briefAndPictureAreAKeyAway()
    {
        WindowFixture w(three());
        w.map().setFocus();
        QTest::keyClick(&w.map(), Qt::Key_P, Qt::ControlModifier);
        QCOMPARE(w.interaction.offers.size(), 1U);
        QCOMPARE(w.interaction.offers.front().suggested.formatId, std::string("brief"));
        QGuiApplication::clipboard()->clear();
        QTest::keyClick(&w.map(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(QGuiApplication::clipboard()->image().size(), w.map().size());
    }

    /** Two in a row, before the first one is written: each goes to its own file. */
    void exportsDoNotMixUp()
    {
        const Scenario scenario = three();
        WindowFixture w(scenario);
        const QString plan = w.file(u"a.plan"_s);
        const QString table = w.file(u"b.csv"_s);
        w.interaction.exportChoice = requestFor("plan", plan);
        w.trigger(u"exportAction"_s);
        w.interaction.exportChoice = requestFor("csv", table);
        w.trigger(u"exportAction"_s);
        QVERIFY(QTest::qWaitFor([&] { return QFile::exists(table); }, 2000));
        QVERIFY(QTest::qWaitFor([&] { return QFile::exists(plan); }, 500));
        QVERIFY(readFile(plan.toStdString()).starts_with('{'));
        QVERIFY(!readFile(table.toStdString()).starts_with('{'));
    }

    void cancelledExportWritesNothing()
    {
        WindowFixture w(three());
        w.trigger(u"exportAction"_s);
        QCOMPARE(w.interaction.offers.size(), 1U);
        QVERIFY(w.until([&] { return w.record().now.phase == RunPhase::Ready; }));
        QCOMPARE(QDir(w.folder.path()).entryList({u"*.plan"_s, u"*.csv"_s}).size(), 0);
    }

    /** One file for each UAV, and one question about all that are there already. */
    void filesOfAFleetAreAskedAboutOnce()
    {
        using Overwrite = Interaction::Overwrite;
        Scenario scenario = three();
        scenario.uavs.push_back(scenario.uavs.front());
        scenario.uavs.back().id = "uav/2";
        scenario.uavs.back().position_m += Point(900, 0);
        WindowFixture w(scenario);
        const QString first =
            w.file(u"fleet-"_s + QString::fromStdString(scenario.uavs.front().id) + u".plan"_s);
        const QString second = w.file(u"fleet-uav_2.plan"_s);
        w.interaction.exportChoice = requestFor("plan", w.file(u"fleet.plan"_s));
        w.trigger(u"exportAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(first) && QFile::exists(second); }));
        QVERIFY(!QFile::exists(w.file(u"fleet.plan"_s)));
        QVERIFY(w.interaction.overwriteReasons.isEmpty());

        for (const Overwrite answer : {Overwrite::Cancel, Overwrite::Overwrite}) {
            for (const QString& path : {first, second})
                writeFileAtomically(path.toStdString(), "old");
            w.interaction.overwrite = answer;
            w.interaction.overwriteReasons.clear();
            w.trigger(u"exportAction"_s);
            QVERIFY(w.until([&] { return !w.interaction.overwriteReasons.isEmpty(); }));
            const bool isUnchanged = answer == Overwrite::Cancel;
            QCOMPARE(readFile(first.toStdString()) == "old", isUnchanged);
            QCOMPARE(readFile(second.toStdString()) == "old", isUnchanged);
            QCOMPARE(w.interaction.overwriteReasons.size(), 1);
        }
    }

    /** An edit before the file is written: neither the plan before nor the one after is written. */
    void exportOfAScenarioThatWasEdited_data()
    {
        QTest::addColumn<QString>("when");
        for (const char* when : {"in the dialog", "after it", "while it asks"})
            QTest::newRow(when) << QString::fromLatin1(when);
    }
    void exportOfAScenarioThatWasEdited()
    {
        QFETCH(QString, when);
        WindowFixture w(three());
        const auto edit = [&] {
            w.document().edit(u"edit"_s, [](Scenario& s) { s.icebergs[0].position_m.x() += 100; });
        };
        const QString path = w.file(u"plan.csv"_s);
        w.interaction.exportChoice = requestFor("csv", path);
        w.interaction.overwrite = Interaction::Overwrite::Overwrite;
        if (when == u"in the dialog"_s)
            w.interaction.whileExportIsChosen = edit;
        if (when == u"while it asks"_s) {
            writeFileAtomically(path.toStdString(), "old");
            w.interaction.whileOverwriteIsAsked = edit;
        }
        w.trigger(u"exportAction"_s);
        if (when == u"after it"_s)
            edit();
        QVERIFY(w.until([&] {
            return w.window().statusBar()->currentMessage().contains(u"Nothing was exported"_s);
        }));
        QVERIFY(w.untilReady());
        if (when == u"while it asks"_s)
            QCOMPARE(readFile(path.toStdString()), std::string("old"));
        else
            QVERIFY(!QFile::exists(path));
    }

    /** Under another name is another choice. */
    void saveAsChoosesAnew()
    {
        WindowFixture w(three());
        const QString path = w.file(u"old.csv"_s);
        writeFileAtomically(path.toStdString(), "old");
        w.interaction.overwrite = Interaction::Overwrite::SaveAs;
        w.interaction.exportChoice = requestFor("csv", path);
        QObject::connect(&w.workspace.runner(), &MissionRunner::exportReady, &w.window(), [&] {
            w.interaction.overwrite = Interaction::Overwrite::Cancel; // the second time
        });
        w.trigger(u"exportAction"_s);
        QVERIFY(w.until([&] { return w.interaction.overwriteReasons.size() == 2; }));
        QCOMPARE(w.interaction.offers.size(), 2U);
        QCOMPARE(readFile(path.toStdString()), std::string("old"));
    }

    void optionsReachTheFileAndAreRemembered()
    {
        WindowFixture w(three());
        const QString path = w.file(u"high.waypoints"_s);
        w.interaction.exportChoice = requestFor("wpl", path);
        w.interaction.exportChoice->options.altitude_m = 321;
        w.interaction.exportChoice->options.loiterTurns = 2;
        w.trigger(u"exportAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(path); }));
        const QString text = QString::fromStdString(readFile(path.toStdString()));
        QVERIFY(text.contains(u"\t321"_s));
        QVERIFY(text.contains(u"\t18\t2"_s)); // NAV_LOITER_TURNS, twice round
        w.trigger(u"exportAction"_s);
        const ExportRequest& suggested = w.interaction.offers.back().suggested;
        QVERIFY(suggested.options == w.interaction.exportChoice->options);
        QCOMPARE(suggested.formatId, std::string("wpl"));

        const MainWindow* before = &w.window();
        w.trigger(u"view/language-nb"_s);
        QVERIFY(w.until([&] { return &w.window() != before; }));
        w.trigger(u"exportAction"_s);
        QVERIFY(w.interaction.offers.back().suggested.options ==
                w.interaction.exportChoice->options);
        w.trigger(u"view/language-en"_s);
        QVERIFY(w.until([&] { return w.settings.value("view/language") == u"en"_s; }));
    }

    /** A failed export is not written with the next one. */
    void refusedExportIsForgotten()
    {
        Scenario scenario = three();
        WindowFixture w(scenario);
        scenario.icebergs[0].q_m2ps = -1;
        w.document().reset(scenario);
        QVERIFY(w.until(RunPhase::Failed));
        const QString refused = w.file(u"refused.csv"_s);
        w.interaction.exportChoice = requestFor("csv", refused);
        w.trigger(u"exportAction"_s);
        w.interaction.path = w.file(u"refused.bergrun"_s);
        w.trigger(u"saveRunAction"_s);

        w.document().reset(three());
        QVERIFY(w.untilReady());
        const QString path = w.file(u"plan.csv"_s);
        w.interaction.exportChoice->path = path;
        w.trigger(u"exportAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(path); }));
        w.interaction.path = w.file(u"flight.bergrun"_s);
        w.trigger(u"saveRunAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(w.interaction.path); }));
        QVERIFY(!QFile::exists(refused));
        QVERIFY(!QFile::exists(w.file(u"refused.bergrun"_s)));
    }
};

QTEST_MAIN(TestMainWindowExport)
#include "tst_main_window_export.moc"
