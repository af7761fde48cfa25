#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "core/scenario/presets.h"
#include "tests/support/window_fixture.h"

#include <QDir>
#include <QFile>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario three()
{
    return randomScenario(31, {.icebergs = 3});
}

} // namespace

/** Plans and runs as files of other programs. */
class TestMainWindowExport : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void exportsWhatTheTableWrites_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<bool>("flown");
        for (const ExportFormat& format : exportFormats())
            for (const bool flown : {false, true}) {
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
        const QString path = w.file(u"plan.out"_s);
        w.interaction.exportChoice = ExportChoice{.formatId = format, .path = path};
        w.trigger(u"exportAction"_s);
        QVERIFY(w.until([&] { return QFile::exists(path); }));
        QCOMPARE(w.interaction.offers.size(), 1U);
        QCOMPARE(w.interaction.offers.front().flown, flown);
        const std::string expected = test::elsewhere([&] {
            Mission mission(scenario);
            mission.advance(flown ? 40 : 0);
            const PlanAnswer plan = planFromStart(scenario);
            return findExportFormat(format.toStdString())
                ->write(
                    {.scenario = scenario, .plan = plan, .mission = flown ? &mission : nullptr});
        });
        QVERIFY(readFile(path.toStdString()) == expected);
        QVERIFY(w.interaction.errors.isEmpty());
    }

    /** Two in a row, before the first one is written: each goes to its own file. */
    void exportsDoNotMixUp()
    {
        const Scenario scenario = three();
        WindowFixture w(scenario);
        const QString plan = w.file(u"a.plan"_s);
        const QString table = w.file(u"b.csv"_s);
        w.interaction.exportChoice = ExportChoice{.formatId = u"plan"_s, .path = plan};
        w.trigger(u"exportAction"_s);
        w.interaction.exportChoice = ExportChoice{.formatId = u"csv"_s, .path = table};
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

    /** What could not be exported is not written with the next one. */
    void refusedExportIsForgotten()
    {
        Scenario scenario = three();
        WindowFixture w(scenario);
        scenario.icebergs[0].q_m2ps = -1;
        w.document().reset(scenario);
        QVERIFY(w.until(RunPhase::Failed));
        const QString refused = w.file(u"refused.csv"_s);
        w.interaction.exportChoice = ExportChoice{.formatId = u"csv"_s, .path = refused};
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
