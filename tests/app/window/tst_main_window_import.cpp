#include "core/presets/presets.h"
#include "tests/support/window/import_dialog_test.h"
#include "tests/support/window/window_fixture.h"

#include <QDragEnterEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QMimeData>
#include <QStatusBar>
#include <QTabWidget>
#include <QUndoStack>

#include <algorithm>

using namespace berg;
using namespace Qt::StringLiterals;
using test::direct;
using test::fixturePath;
using test::WindowFixture;
using test::written;

namespace {

/** A person who waits for the preview and presses Import. */
auto accepts()
{
    return [](ImportRunner& runner, const ImportOffer& offer) {
        ImportDialog dialog(runner, offer);
        if (!QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000))
            qFatal("no preview");
        return dialog.choice();
    };
}

const QByteArray kZoneOfNoPlace = "AC D\nAN NOWHERE\nAL GND\nAH FL100\nDP nowhere\n";

/** An ice chart of one triangle there. */
QByteArray iceAt(const LatLon& origin)
{
    const auto corner = [&](double north, double east) {
        return '[' + QByteArray::number(origin.longitude_deg + east) + ',' +
               QByteArray::number(origin.latitude_deg + north) + ']';
    };
    return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":)"
           R"({"CT":"46","POLY_TYPE":"I"},"geometry":{"type":"Polygon","coordinates":[[)" +
           corner(0, 0) + ',' + corner(0, 0.2) + ',' + corner(0.1, 0) + ',' + corner(0, 0) +
           "]]}}]}";
}

/** A triangle of 5 km there. */
QByteArray zoneAt(const LatLon& origin)
{
    QByteArray text = "AC D\nAN ZONE\nAL GND\nAH FL100\n";
    const LocalFrame frame(origin);
    for (const Point& corner_m : {Point(0, 0), Point(5000, 0), Point(0, 5000)}) {
        const LatLon place = frame.toGeographic(corner_m);
        const auto angle = [](double deg, char positive, char negative) {
            return QByteArray::number(std::abs(deg), 'f', 6) + (deg < 0 ? negative : positive);
        };
        text += "DP " + angle(place.latitude_deg, 'N', 'S') + ' ' +
                angle(place.longitude_deg, 'E', 'W') + '\n';
    }
    return text;
}

void drop(QWidget& window, const QString& path)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(window.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &enter);
    QDropEvent event(window.rect().center(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &event);
}

} // namespace

/** Imports in the real window. */
class TestMainWindowImport : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void rejectedRowsAreCountedWhereNoneIsLeft()
    {
        QTemporaryDir folder;
        const QString path =
            written(folder.filePath(u"own.csv"_s), "id,lat,lon\na,91,-50\nb,x,-50\n");
        test::Importing import(path);
        QVERIFY(import.settles());
        QVERIFY(!import.canImport());
        QCOMPARE(import.rows(u"importRejected"_s).rowCount(), 2);
        QVERIFY(import.at<QTabWidget>(u"importTabs"_s).tabText(1).contains(u"(2)"_s));
    }

    /** Read on a thread of its own, into the scenario as it is when that has ended. */
    void airspaceIsOneUndoStep()
    {
        WindowFixture w(test::openSea());
        const Scenario before = w.scenario();
        w.interaction.path = written(w.file(u"zones.openair"_s), zoneAt(before.origin));
        w.trigger(u"airspaceAction"_s);
        w.document().edit(u"Other"_s, [](Scenario& scenario) { scenario.seed = 99; });
        QTRY_COMPARE(w.scenario().airspace.size(), std::size_t{1});
        QCOMPARE(w.scenario().seed, std::int64_t{99});
        QVERIFY(w.window().statusBar()->currentMessage().contains(u"1 area added"_s));
        w.document().undoStack()->undo();
        w.document().undoStack()->undo();
        QVERIFY(w.scenario() == before);
    }

    void iceChartIsOneUndoStep_data()
    {
        QTest::addColumn<QString>("action"); // empty for a dropped file
        for (const char* action : {"iceChartAction", "importAction", ""})
            QTest::newRow(action) << QString::fromLatin1(action);
    }

    /** Whether it is chosen as one or as sightings, or dropped. */
    void iceChartIsOneUndoStep()
    {
        QFETCH(QString, action);
        WindowFixture w(test::openSea());
        const Scenario before = w.scenario();
        w.interaction.path = written(w.file(u"ice_20210118.geojson"_s), iceAt(before.origin));
        if (action.isEmpty())
            drop(w.window(), w.interaction.path);
        else
            w.trigger(action);
        QVERIFY(w.until([&] { return w.scenario().iceChart.has_value(); }));
        QCOMPARE(w.scenario().iceChart->areas.size(), std::size_t{1});
        QCOMPARE(w.scenario().iceChart->dateUtc, std::string("2021-01-18T00:00:00Z"));
        QVERIFY(w.window().statusBar()->currentMessage().contains(u"1 area, date 2021-01-18"_s));
        QVERIFY(w.interaction.importOffers.empty());
        w.document().undoStack()->undo();
        QVERIFY(w.scenario() == before);
    }

    /** Sightings of a file that may hold an ice chart go to the dialog. */
    void gisFilesWithoutIceAreSightings()
    {
        WindowFixture w(test::openSea());
        const QString path = written(w.file(u"table.dxf"_s), "id,lat,lon\na,60,-50\nb,60.1,-50\n");
        w.interaction.importAnswer = accepts();
        drop(w.window(), path);
        QVERIFY(w.until([&] { return w.scenario().icebergs.size() == 2; }));
        QVERIFY(w.interaction.errors.isEmpty());
    }

    /** Why each area was left out, and where it is in the file. */
    void airspaceThatIsLeftOutHasItsReason()
    {
        WindowFixture w(test::openSea());
        w.interaction.path = written(w.file(u"zones.openair"_s), kZoneOfNoPlace);
        w.trigger(u"airspaceAction"_s);
        QTRY_COMPARE(w.interaction.errors.size(), 1);
        QVERIFY(w.interaction.errors[0].contains(u"1 left out"_s));
        QVERIFY2(w.interaction.errors[0].contains(u"line 5: airspace left out"_s),
                 qPrintable(w.interaction.errors[0]));
    }

    /** A successful import shows no error. */
    void airspaceThatIsLeftOutInPartIsReported()
    {
        WindowFixture w(test::openSea());
        w.interaction.path =
            written(w.file(u"zones.openair"_s), zoneAt(w.scenario().origin) + kZoneOfNoPlace);
        w.trigger(u"airspaceAction"_s);
        QTRY_COMPARE(w.interaction.informations.size(), 1);
        QVERIFY2(w.interaction.informations[0].contains(u"line 12: airspace left out"_s),
                 qPrintable(w.interaction.informations[0]));
        QVERIFY(w.interaction.errors.isEmpty());
        QCOMPARE(w.scenario().airspace.size(), std::size_t{1});
    }

    void isOneUndoStep()
    {
        WindowFixture w(test::openSea());
        const Scenario before = w.scenario();
        w.interaction.path = fixturePath("iip.csv");
        w.interaction.importAnswer = accepts();
        w.trigger(u"importAction"_s);
        const ImportResult core = direct("iip.csv", before);
        QVERIFY(w.scenario() == core.scenario);
        QCOMPARE(w.document().undoStack()->count(), 1);
        QCOMPARE(w.document().undoStack()->undoText(),
                 u"Import %1 icebergs from iip.csv"_s.arg(core.added));
        QVERIFY(w.window().statusBar()->currentMessage().contains(u"iip.csv"_s));
        QVERIFY(w.untilReady());
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == before);
        w.trigger(u"redoAction"_s);
        QVERIFY(w.scenario() == core.scenario);
    }

    void newScenarioAsksAboutTheOld_data()
    {
        QTest::addColumn<bool>("discard");
        QTest::newRow("cancel") << false;
        QTest::newRow("discard") << true;
    }

    void newScenarioAsksAboutTheOld()
    {
        QFETCH(bool, discard);
        WindowFixture w(randomScenario(31, {.icebergs = 3}));
        w.document().edit(u"x"_s, [](Scenario& scenario) { scenario.name = "mine"; });
        const Scenario before = w.scenario();
        w.interaction.unsaved =
            discard ? Interaction::Unsaved::Discard : Interaction::Unsaved::Cancel;
        w.interaction.path = fixturePath("usnic.csv");
        w.interaction.importAnswer = [](ImportRunner& runner, ImportOffer offer) {
            offer.intoNew = true;
            return accepts()(runner, offer);
        };
        w.trigger(u"importAction"_s);
        QCOMPARE(w.interaction.unsavedNames, QStringList{u"mine"_s});
        if (discard) {
            QVERIFY(w.scenario() == direct("usnic.csv", newScenarioForImport("usnic")).scenario);
            QVERIFY(!w.document().isClean()); // it is in no file
            QVERIFY(w.document().filePath().isEmpty());
        } else {
            QVERIFY(w.scenario() == before);
            QCOMPARE(w.document().undoStack()->count(), 1);
        }
    }

    /** None of the sightings is near: one press makes a scenario of them. */
    void sightingsThatFitNowhereAreOfferedAScenario()
    {
        Scenario far = randomScenario(31, {.icebergs = 3});
        far.origin = {.latitude_deg = -40, .longitude_deg = 100};
        WindowFixture w(far);
        w.interaction.path = fixturePath("iip.csv");
        QString before;
        w.interaction.importAnswer = [&](ImportRunner& runner, const ImportOffer& offer) {
            ImportDialog dialog(runner, offer);
            dialog.show();
            const auto settles = [&] {
                return QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000);
            };
            auto& offered = test::child<QPushButton>(dialog, u"importNewButton"_s);
            if (!settles() || dialog.choice() || !offered.isVisible())
                qFatal("nothing is offered");
            before = test::child<QLabel>(dialog, u"importSummary"_s).text();
            auto& tabs = test::child<QTabWidget>(dialog, u"importTabs"_s);
            if (tabs.currentIndex() != 1)
                qFatal("the reasons are not shown");
            offered.click();
            if (!settles() || offered.isVisible())
                qFatal("no preview");
            return dialog.choice();
        };
        w.trigger(u"importAction"_s);
        QVERIFY(before.contains(u"rejected"_s));
        QVERIFY(w.scenario() == direct("iip.csv", newScenarioForImport("iip")).scenario);
    }

    void cancelLeavesAllAsItWas()
    {
        WindowFixture w(randomScenario(31, {.icebergs = 3}));
        const Scenario before = w.scenario();
        w.trigger(u"importAction"_s); // no file
        QVERIFY(w.interaction.importOffers.empty());
        w.interaction.path = fixturePath("usnic.csv");
        w.trigger(u"importAction"_s);
        QCOMPARE(w.interaction.importOffers.size(), 1U);
        QVERIFY(*w.interaction.importOffers.front().present == before);
        QVERIFY(w.scenario() == before);
        QVERIFY(w.document().isClean());
        QVERIFY(w.interaction.errors.isEmpty());
    }

    /** Then they are reports to the flight, whose t = 0 is now: `tst_main_window_reports`. */
    void inFlightTheyAreReports()
    {
        WindowFixture w(randomScenario(31, {.icebergs = 3}));
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QVERIFY(w.until(RunPhase::Paused));
        w.interaction.path = fixturePath("usnic.csv");
        w.trigger(u"importAction"_s);
        drop(w.window(), w.interaction.path);
        QVERIFY(w.until([&] { return w.interaction.importOffers.size() == 2; }));
        for (const ImportOffer& offer : w.interaction.importOffers)
            QVERIFY(offer.inFlight && !offer.intoNew && offer.present->icebergs.size() == 3);
        w.interaction.path = written(w.file(u"zones.openair"_s), zoneAt(w.scenario().origin));
        w.trigger(u"airspaceAction"_s);
        QVERIFY(w.window().statusBar()->currentMessage().startsWith(u"Airspace"_s));
        QVERIFY(w.scenario().airspace.empty());
    }

    void droppedFilesAreImported_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending :
             {"csv", "txt", "geojson", "json", "kml", "gpx", "plan", "waypoints", "CSV"})
            QTest::newRow(ending) << QString::fromLatin1(ending);
    }

    void droppedFilesAreImported()
    {
        QFETCH(QString, ending);
        WindowFixture w(test::openSea());
        const QString path =
            written(w.file(u"dropped."_s + ending), "id,lat,lon\na,60,-50\nb,60.1,-50\n");
        w.interaction.importAnswer = accepts();
        drop(w.window(), path);
        QVERIFY(w.until([&] { return w.scenario().icebergs.size() == 2; }));
        QCOMPARE(w.interaction.importOffers.front().path, path);
        QVERIFY(w.interaction.unsavedNames.isEmpty());
    }

    void airspaceFindsItsWay_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<bool>("isDropped");
        for (const char* ending : {"openair", "air", "txt", "TXT"})
            QTest::addRow("%s dropped", ending) << QString::fromLatin1(ending) << true;
        QTest::newRow("given as sightings") << u"txt"_s << false;
    }

    void airspaceFindsItsWay()
    {
        QFETCH(QString, ending);
        QFETCH(bool, isDropped);
        WindowFixture w(test::openSea());
        const QString path = written(w.file(u"zones."_s + ending), zoneAt(w.scenario().origin));
        if (isDropped) {
            drop(w.window(), path);
        } else {
            w.interaction.path = path;
            w.trigger(u"importAction"_s);
        }
        QVERIFY(w.until([&] { return w.scenario().airspace.size() == 1; }));
        QVERIFY(w.interaction.importOffers.empty());
        QVERIFY(w.interaction.errors.isEmpty());
    }

    /** From the start page a new scenario is the first choice. */
    void startPageImports()
    {
        WindowFixture w(randomScenario(31, {.icebergs = 3}));
        w.window().parts().start.showPage();
        w.interaction.path = fixturePath("metno.geojson");
        auto& button = test::child<QPushButton>(w.window(), u"startImportButton"_s);
        button.click();
        QVERIFY(w.window().parts().start.pageIsShown()); // cancelled
        QVERIFY(w.interaction.importOffers.front().intoNew);
        w.interaction.importAnswer = accepts();
        button.click();
        QVERIFY(!w.window().parts().start.pageIsShown());
        QCOMPARE(w.scenario().name, std::string("metno"));
        QCOMPARE(w.scenario().icebergs.size(), 4U);
    }

    void recordedTrackCanBeCleared()
    {
        ImportOptions options;
        options.at = test::utc("2012-07-03T00:00:00Z");
        options.withTracks = true;
        const Scenario tracked = direct("cis-beacon.csv", test::openSea(), options).scenario;
        const auto it = std::find_if(tracked.icebergs.begin(), tracked.icebergs.end(),
                                     [](const Iceberg& iceberg) { return !iceberg.track.empty(); });
        QVERIFY(it != tracked.icebergs.end());
        WindowFixture w(tracked);
        w.workspace.selection().set({it->id});
        auto& button = test::child<QPushButton>(w.window(), u"icebergTrackClear"_s);
        QVERIFY(!button.isHidden() && !button.parentWidget()->isHidden());
        button.click();
        QCOMPARE(w.document().undoStack()->count(), 1);
        for (const Iceberg& iceberg : w.scenario().icebergs)
            QVERIFY(iceberg.id != it->id || iceberg.track.empty());
        QVERIFY(button.parentWidget()->isHidden());
        w.trigger(u"undoAction"_s);
        QVERIFY(w.scenario() == tracked);
        QVERIFY(!button.parentWidget()->isHidden());
    }

    /** Neither the window nor the program waits for a large file that is being read. */
    void closesWhileALargeFileIsRead()
    {
        auto w = std::make_unique<WindowFixture>(test::openSea());
        QByteArray table("id,latitude,longitude,time\n");
        for (int i = 0; i < 1'000'000; ++i)
            table += "berg-" + QByteArray::number(i) + ",47.1234,-48.5678,2021-04-01T00:00:00Z\n";
        QFile file(w->file(u"large.csv"_s));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(table) == table.size());
        file.close();
        w->workspace.imports().start(
            {.path = file.fileName(), .base = std::make_shared<const Scenario>(test::openSea())},
            true);
        QTest::qWait(300); // it is being read
        QVERIFY(w->workspace.imports().isBusy());
        constexpr qint64 kLongest_ms = 60'000; // on any machine; tst_import_stop counts its work
        QElapsedTimer clock;
        clock.start();
        QVERIFY(w->window().close());
        w.reset();
        QVERIFY2(clock.elapsed() < kLongest_ms, QByteArray::number(clock.elapsed()).constData());
    }
};

QTEST_MAIN(TestMainWindowImport)
#include "tst_main_window_import.moc"
