#include "app/dialogs/import_options_view.h"
#include "tests/support/window/import_dialog_test.h"
#include "widgets/words/import_text.h"
#include "widgets/words/issue_text.h"

#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QTabWidget>

#include <algorithm>
#include <memory>
#include <set>

using namespace berg;
using namespace Qt::StringLiterals;
using test::direct;
using test::fixturePath;
using test::Importing;
using test::written;

namespace {

/** A table of about this size, with an iceberg every fiftieth row. */
QString bigTable(const QString& path, qint64 size)
{
    QByteArray text("id,time,latitude,longitude,comment\n");
    text.reserve(size + 200);
    const QByteArray filling(120, 'x');
    for (int i = 0; text.size() < size; ++i)
        text += "b-" + QByteArray::number(i / 50) + ",2024-05-01T" +
                QByteArray::number(10 + i % 10) + ":" + QByteArray::number(10 + i % 50) + ":00Z," +
                QByteArray::number(60 + i % 100 * 0.01) + ",-50," + filling + '\n';
    return written(path, text);
}

} // namespace

/** Importing sightings: the dialog by itself. */
class TestImportDialog : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void everyFormatComesOutAsFromTheCore_data()
    {
        QTest::addColumn<int>("fixture");
        for (std::size_t i = 0; i < test::kImportFixtures.size(); ++i)
            QTest::newRow(test::kImportFixtures[i].file) << static_cast<int>(i);
    }

    void everyFormatComesOutAsFromTheCore()
    {
        QFETCH(int, fixture);
        const test::ImportFixture& expected =
            test::kImportFixtures[static_cast<std::size_t>(fixture)];
        Importing import(fixturePath(expected.file));
        QVERIFY(!import.canImport()); // nothing is known yet
        QVERIFY(!import.dialog().choice());
        QVERIFY(import.settles());
        const ImportResult core = direct(expected.file, test::openSea());
        QVERIFY(import.canImport());
        QVERIFY(import.dialog().choice()->scenario == core.scenario);
        QCOMPARE(import.dialog().choice()->icebergs, int(core.added + core.updated));
        QCOMPARE(import.rows(u"importIcebergs"_s).rowCount(), int(core.icebergs.size()));
        QCOMPARE(import.cell(u"importIcebergs"_s, 0, 0),
                 QString::fromStdString(core.icebergs.front().id));
        QVERIFY(import.at<QComboBox>(u"importFormat"_s)
                    .itemText(0)
                    .endsWith(importFormatName(expected.format)));
        QVERIFY(import.error().isEmpty());
        const auto& map = import.at<MapView>(u"importMap"_s);
        QVERIFY(map.isVisible());
    }

    /** Every broken row with its line, and the table can be taken along. */
    void rejectedRowsAreListed()
    {
        Importing import(fixturePath("iip.csv"));
        QVERIFY(import.settles());
        Rejections core = direct("iip.csv", test::openSea()).rejected;
        std::ranges::stable_sort(core.first, {}, &RejectedRow::line);
        const QAbstractItemModel& rows = import.rows(u"importRejected"_s);
        QCOMPARE(rows.rowCount(), int(core.count));
        for (int row = 0; const RejectedRow& rejected : core.first) {
            QCOMPARE(import.cell(u"importRejected"_s, row, 0), QString::number(rejected.line));
            QCOMPARE(import.cell(u"importRejected"_s, row, 1), issueWords(rejected.fault));
            QCOMPARE(import.cell(u"importRejected"_s, row++, 2),
                     QString::fromStdString(rejected.detail));
        }
        QVERIFY(import.summary().contains(u"4 rows rejected"_s));
        import.at<QTabWidget>(u"importTabs"_s).setCurrentIndex(1);
        auto& table = import.at<QTableView>(u"importRejected"_s);
        table.selectRow(2);
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines = QGuiApplication::clipboard()->text().trimmed().split(u'\n');
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[1].startsWith(import.cell(u"importRejected"_s, 2, 0) + u'\t'));
    }

    /** Columns whose names say nothing; the dialog shows them so that they can be named. */
    void columnsAreNamedByHand()
    {
        QTemporaryDir folder;
        const QString path =
            written(folder.filePath(u"own.csv"_s), "sep=,\n# of a ship\nwho,when seen,up,right\n"
                                                   "a,2024-05-01T00:00:00Z,60.1,-50.2\n"
                                                   "b,2024-05-01T01:00:00Z,60.2,-50.3\n");
        Importing import(path);
        QVERIFY(import.settles());
        QVERIFY(!import.canImport());
        QVERIFY(import.error().contains(u"own.csv"_s));
        auto& tabs = import.at<QTabWidget>(u"importTabs"_s);
        QCOMPARE(tabs.tabText(tabs.currentIndex()), u"Columns"_s);
        QCOMPARE(import.rows(u"importHead"_s).rowCount(), 2);
        QCOMPARE(import.cell(u"importHead"_s, 1, 2), u"60.2"_s);
        import.choose(u"column-id"_s, 1);
        import.choose(u"column-time"_s, 2);
        import.choose(u"column-latitude"_s, 3);
        import.choose(u"column-longitude"_s, 4);
        QVERIFY(import.settles());
        QVERIFY(import.canImport());
        const Scenario scenario = import.dialog().choice()->scenario;
        QCOMPARE(scenario.icebergs.size(), 2U);
        QCOMPARE(scenario.icebergs[1].id, std::string("b"));
        QCOMPARE(import.rows(u"importHead"_s).headerData(2, Qt::Horizontal).toString(),
                 u"up\nLatitude"_s);
        QCOMPARE(import.at<QComboBox>(u"column-latitude"_s).currentText(), u"up"_s);
    }

    /** The guess is preselected and can be overruled. */
    void guessesAreShown()
    {
        QTemporaryDir folder;
        const QString path =
            written(folder.filePath(u"two.csv"_s), "id,time,lat,lon,place\n"
                                                   "a,2024-05-01T00:00:00Z,60,-50,61\n");
        Importing import(path);
        QVERIFY(import.settles());
        auto& latitude = import.at<QComboBox>(u"column-latitude"_s);
        QCOMPARE(latitude.currentText(), u"Automatic: lat"_s);
        QCOMPARE(import.dialog().choice()->scenario.origin.latitude_deg, 60.0);
        import.choose(u"column-latitude"_s, latitude.findText(u"place"_s));
        QVERIFY(!import.dialog().choice()); // of what was asked for before
        QVERIFY(import.settles());
        QCOMPARE(import.dialog().choice()->scenario.origin.latitude_deg, 61.0);
        import.choose(u"importFormat"_s, 0); // begins anew
        QVERIFY(import.settles());
        QCOMPARE(import.dialog().choice()->scenario.origin.latitude_deg, 60.0);
    }

    void anotherFormatIsRefusedWithWords()
    {
        Importing import(fixturePath("table.csv"));
        QVERIFY(import.settles());
        auto& formats = import.at<QComboBox>(u"importFormat"_s);
        import.choose(u"importFormat"_s, formats.findData(u"kml"_s));
        QVERIFY(import.settles());
        QVERIFY(!import.canImport());
        QVERIFY(import.error().contains(u"table.csv"_s));
        QVERIFY(!import.at<MapView>(u"importMap"_s).isVisible());
        import.choose(u"importFormat"_s, formats.findData(u"csv"_s));
        QVERIFY(import.settles());
        QVERIFY(import.canImport());
        QVERIFY(import.at<MapView>(u"importMap"_s).isVisible());
    }

    void optionsAreThoseOfTheCore()
    {
        Importing import(fixturePath("cis-beacon.csv"));
        QVERIFY(import.settles());
        ImportOptions options;
        options.at = test::utc("2012-07-03T06:00:00Z");
        import.setTime(u"importAt"_s, "2012-07-03T06:00:00Z");
        QVERIFY(import.settles());
        QVERIFY(import.dialog().choice()->scenario ==
                direct("cis-beacon.csv", test::openSea(), options).scenario);

        options.withTracks = true;
        import.check(u"importTracks"_s);
        QVERIFY(import.settles());
        const Scenario tracked = direct("cis-beacon.csv", test::openSea(), options).scenario;
        QVERIFY(import.dialog().choice()->scenario == tracked);
        QVERIFY(std::any_of(tracked.icebergs.begin(), tracked.icebergs.end(),
                            [](const Iceberg& iceberg) { return !iceberg.track.empty(); }));

        options.since = test::utc("2012-07-03T02:00:00Z");
        options.until = test::utc("2012-07-03T12:00:00Z");
        import.setTime(u"importSince"_s, "2012-07-03T02:00:00Z");
        import.setTime(u"importUntil"_s, "2012-07-03T12:00:00Z");
        options.positionSd_m = 250;
        options.q_m2ps = 0.5;
        test::enter(import.at<QWidget>(u"importPositionError"_s), u"250"_s);
        test::enter(import.at<QWidget>(u"importGrowth"_s), QLocale().toString(0.5));
        QVERIFY(import.settles());
        const ImportResult core = direct("cis-beacon.csv", test::openSea(), options);
        QVERIFY(core.outsideTime > 0);
        QVERIFY(import.dialog().choice()->scenario == core.scenario);
        QVERIFY(import.summary().contains(u"outside the time"_s));
        QVERIFY(import.dialog().isVisible()); // Return in a field imports nothing
    }

    void areaLeavesOut()
    {
        Importing import(fixturePath("points.geojson"));
        QVERIFY(import.settles());
        const std::size_t all = import.dialog().choice()->scenario.icebergs.size();
        import.check(u"importAreaBox"_s);
        test::enter(import.at<QWidget>(u"importEdge0"_s), u"69.15"_s);
        QVERIFY(import.settles());
        const ImportOptions options{.area = GeoBox{.south_deg = 69.15}};
        const ImportResult core = direct("points.geojson", test::openSea(), options);
        QVERIFY(core.outsideArea > 0);
        QVERIFY(core.scenario.icebergs.size() < all);
        QVERIFY(import.dialog().choice()->scenario == core.scenario);
        QVERIFY(import.summary().contains(u"outside the area"_s));

        import.at<QPushButton>(u"importPresentView"_s).click(); // which shows what is left
        QVERIFY(import.settles());
        QCOMPARE(import.dialog().choice()->scenario.icebergs.size(), core.scenario.icebergs.size());
        QVERIFY(import.at<QDoubleSpinBox>(u"importEdge1"_s).value() > -100);
    }

    void boxGoesRoundTheOutline_data()
    {
        QTest::addColumn<QList<double>>("places"); // latitude, longitude, ...
        QTest::addColumn<QList<double>>("box");    // south, west, north, east
        QTest::newRow("plain") << QList<double>{60, -50, 60, -40, 65, -40, 65, -50}
                               << QList<double>{60, -50, 65, -40};
        QTest::newRow("antimeridian") << QList<double>{60, 170, 60, -170, 65, -170, 65, 170}
                                      << QList<double>{60, 170, 65, -170};
        QTest::newRow("pole") << QList<double>{85, 0, 86, 90, 85, 180, 85, -90}
                              << QList<double>{85, -180, 90, 180};
        QTest::newRow("south pole") << QList<double>{-85, 0, -86, 90, -85, 180, -85, -90}
                                    << QList<double>{-90, -180, -85, 180};
    }

    void boxGoesRoundTheOutline()
    {
        QFETCH(QList<double>, places);
        QFETCH(QList<double>, box);
        std::vector<LatLon> outline;
        for (qsizetype i = 0; i < places.size(); i += 2)
            outline.push_back({places[i], places[i + 1]});
        const GeoBox expected{box[0], box[1], box[2], box[3]};
        QVERIFY(boxRound(outline) == expected);
        std::reverse(outline.begin(), outline.end());
        QVERIFY(boxRound(outline) == expected);
    }

    void newAndUpdatedAreReported()
    {
        const Scenario before = direct("points.geojson", test::openSea()).scenario;
        Scenario present = before;
        present.icebergs.erase(present.icebergs.begin());
        present.icebergs.front().observed_s += 3600; // so that the file has news
        const ImportResult core = direct("points.geojson", present);
        QVERIFY(core.added > 0 && core.updated > 0);
        Importing import(fixturePath("points.geojson"), present);
        QVERIFY(import.settles());
        QVERIFY(import.dialog().choice()->scenario == core.scenario);
        QVERIFY(!import.dialog().choice()->intoNew);
        QVERIFY(
            import.summary().startsWith(u"%1 new, %2 updated"_s.arg(core.added).arg(core.updated)));
        import.choose(u"importTarget"_s, 1);
        QVERIFY(import.settles());
        Scenario fresh = newScenarioForImport("points");
        QVERIFY(import.dialog().choice()->scenario == direct("points.geojson", fresh).scenario);
        QVERIFY(import.dialog().choice()->intoNew);
    }

    /** UAVs, area and asset of the file: taken over into a new scenario only, and said. */
    void restOfTheFileIsReported()
    {
        Importing import(fixturePath("fence.plan"), test::openSea(), true);
        QVERIFY(import.settles());
        const auto& scene = import.at<QLabel>(u"importScene"_s);
        QVERIFY(scene.isVisible());
        QVERIFY(
            scene.text().startsWith(u"From the file: 1 UAV taken over; area taken over as "
                                    u"geofence; 2 no-fly areas taken over; "
                                    "2 areas left out: unreadable; 2 further areas left out"_s));
        QVERIFY(import.dialog().choice()->scenario.geofence);

        Importing used(fixturePath("fence.plan"), direct("fence.plan", test::openSea()).scenario);
        QVERIFY(used.settles());
        QVERIFY(
            used.at<QLabel>(u"importScene"_s)
                .text()
                .startsWith(u"From the file: UAVs, area and asset of the file not taken over"_s));

        Importing plain(fixturePath("iip.csv"));
        QVERIFY(plain.settles());
        QCOMPARE(plain.at<QLabel>(u"importScene"_s).text(),
                 u"Velocities are uncertain, so the scenario will use the Kalman filter."_s);
    }

    /** The fifth of February or the second of May: nobody is to find out later. */
    void guessedDateIsReported()
    {
        const QTemporaryDir folder;
        Importing import(
            written(folder.filePath(u"dates.csv"_s), "lat,lon,time\n60.1,-50.2,05/02/2021\n"));
        QVERIFY(import.settles());
        const auto& scene = import.at<QLabel>(u"importScene"_s);
        QVERIFY(scene.text().startsWith(u"Line 2: 05/02/2021 "_s));
        QCOMPARE(import.dialog().choice()->scenario.startUtc, std::string("2021-05-02T00:00:00Z"));
        QVERIFY(import.at<QComboBox>(u"importDates"_s).isVisible());
        import.choose(u"importDates"_s, 2); // the day comes first
        QVERIFY(import.settles());
        QCOMPARE(import.dialog().choice()->scenario.startUtc, std::string("2021-02-05T00:00:00Z"));
        QVERIFY(!scene.text().contains(u"05/02/2021"_s) && scene.text().contains(u"Kalman"_s));
        QVERIFY(import.at<QComboBox>(u"importDates"_s).isVisible()); // to choose anew
        QVERIFY(import.at<QLineEdit>(u"importSince"_s).text().startsWith(u"2021-02-05 "_s));
    }

    void findingsHaveWords()
    {
        std::set<QString> shown;
        const int count = static_cast<int>(SceneNote::NumberWrong) + 1;
        for (int i = 0; i < count; ++i)
            for (const std::size_t number : {std::size_t{1}, std::size_t{3}}) {
                const SceneFinding finding{.note = static_cast<SceneNote>(i), .count = number};
                const QString words = sceneSummary({finding});
                QVERIFY2(!words.contains(u'%') && !words.contains(u"(s)"_s), qPrintable(words));
                QVERIFY(words.endsWith(QString::fromStdString(sceneFindingText(finding))));
                shown.insert(words);
            }
        QVERIFY(static_cast<int>(shown.size()) >= count);
    }

    void whatCannotBeReadIsSaid_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("reason");
        QTest::newRow("binary") << QByteArray("\x7F\0\1\2ELF", 7) << u"no text file"_s;
        QTest::newRow("empty") << QByteArray() << u"is empty"_s;
        QTest::newRow("archive") << QByteArray("PK\x03\x04 and so on") << u"archive"_s;
        QTest::newRow("broken JSON")
            << QByteArray(R"({"type": "FeatureCollection", "features": [{"coordinates": [-50,)")
            << u"broken"_s;
        QTest::newRow("broken rows")
            << QByteArray("id,time,lat,lon\na,2024-05-01T00:00:00Z,99,0\n") << u"line 2"_s;
        QTest::newRow("prose") << QByteArray("There once was an iceberg.") << u"not recognise"_s;
    }

    void whatCannotBeReadIsSaid()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, reason);
        QTemporaryDir folder;
        Importing import(written(folder.filePath(u"odd.csv"_s), content));
        QVERIFY(import.settles());
        QVERIFY(!import.canImport());
        QVERIFY(!import.dialog().choice());
        QVERIFY2(import.error().contains(u"odd.csv"_s), qPrintable(import.error()));
        QVERIFY2(import.error().contains(reason), qPrintable(import.error()));
    }

    void tooLargeAndMissingFilesAreSaid()
    {
        QTemporaryDir folder;
        QFile large(folder.filePath(u"large.csv"_s));
        QVERIFY(large.open(QIODevice::WriteOnly) && large.resize((65LL << 20U)));
        Importing tooLarge(large.fileName());
        QVERIFY(tooLarge.settles());
        QVERIFY(tooLarge.error().contains(u"too large"_s));
        Importing gone(folder.filePath(u"gone.csv"_s));
        QVERIFY(gone.settles());
        QVERIFY(gone.error().contains(u"gone.csv"_s));
        QVERIFY(!gone.canImport());
    }

    /** A file that has been read is not read again. */
    void theFileMayChangeMeanwhile()
    {
        QTemporaryDir folder;
        const QString path = written(folder.filePath(u"f.csv"_s),
                                     QByteArray::fromStdString(test::importFixture("table.csv")));
        Importing import(path);
        QVERIFY(import.settles());
        const Scenario before = import.dialog().choice()->scenario;
        QVERIFY(QFile::remove(path));
        import.choose(u"importFormat"_s, 0);
        QVERIFY(import.settles());
        QVERIFY(import.dialog().choice()->scenario == before);
    }

    /** While a large file is read, the dialog answers, and Cancel does not wait for it. */
    void largeFileCanBeCancelled()
    {
        QTemporaryDir folder;
        const QString path = bigTable(folder.filePath(u"big.csv"_s), 55LL << 20U);
        ImportRunner runner; // waits for its thread after the dialog is gone
        QSignalSpy ready(&runner, &ImportRunner::ready);
        auto dialog = std::make_unique<ImportDialog>(
            runner, ImportOffer{.path = path,
                                .present = std::make_shared<const Scenario>(test::openSea())});
        QSignalSpy rejected(dialog.get(), &QDialog::rejected);
        dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get()));
        QVERIFY(runner.isBusy());
        QCOMPARE(ready.size(), 0);
        test::child<QPushButton>(*dialog, u"importCancel"_s).click();
        QCOMPARE(rejected.size(), 1);
        QVERIFY(!dialog->choice());
        dialog.reset();
        QVERIFY(!runner.isBusy());
        QCOMPARE(ready.size(), 0);
    }

    void largeFileIsTaken()
    {
        QTemporaryDir folder;
        Importing import(bigTable(folder.filePath(u"big.csv"_s), 20LL << 20U));
        QVERIFY(import.settles());
        if (import.at<QCheckBox>(u"importConsent"_s).isVisible())
            import.check(u"importConsent"_s);
        QVERIFY(import.canImport());
        QCOMPARE(import.dialog().choice()->scenario.icebergs.size(), 1000U); // as many as it holds
        QVERIFY(import.summary().contains(u"left out"_s));
        QVERIFY(import.at<QTabWidget>(u"importTabs"_s).tabText(0).contains(u"(first 2000 of "_s));
    }

    /** The newest request wins, however fast they come. */
    void onlyTheNewestIsShown()
    {
        Importing import(fixturePath("iip.csv"));
        QSignalSpy ready(&import.runner(), &ImportRunner::ready);
        for (int i = 0; i < 20; ++i)
            import.choose(u"importTarget"_s, (i + 1) % 2);
        QVERIFY(import.settles());
        QCOMPARE(ready.size(), 1);
        QVERIFY(!import.dialog().choice()->intoNew);
        QVERIFY(import.dialog().choice()->scenario == direct("iip.csv", test::openSea()).scenario);
    }

    void rowAndMapMarkTheSame()
    {
        Importing import(fixturePath("points.geojson"));
        QVERIFY(import.settles());
        auto& table = import.at<QTableView>(u"importIcebergs"_s);
        auto& map = import.at<MapView>(u"importMap"_s);
        const Scenario scenario = import.dialog().choice()->scenario;
        const Iceberg& second = scenario.icebergs[1];
        QTest::mouseClick(&map, Qt::LeftButton, {}, map.toScreen(second.position_m).toPoint());
        const QModelIndexList rows = table.selectionModel()->selectedRows();
        QCOMPARE(rows.size(), 1);
        QCOMPARE(rows.front().data().toString(), QString::fromStdString(second.id));
        QTest::keyClick(&map, Qt::Key_Delete);
        QVERIFY(import.dialog().choice()->scenario == scenario);
    }

    void everythingIsReachedByTab()
    {
        Importing import(fixturePath("table.csv"));
        QVERIFY(import.settles());
        QVERIFY(import.at<QPushButton>(u"importButton"_s).isDefault());
        import.dialog().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&import.dialog()));
        std::set<QString> reached;
        for (int i = 0; i < 80; ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            reached.insert(QApplication::focusWidget()->objectName());
        }
        for (const char* name :
             {"importFormat", "importTarget", "importAtBox", "importSinceBox", "importUntilBox",
              "importAreaBox", "importPresentView", "importSource", "importPositionError",
              "importSpread", "importVelocityTime", "importGrowth", "importMap", "importIcebergs",
              "importButton", "importCancel"})
            QVERIFY2(reached.count(QString::fromLatin1(name)) == 1, name);
        QVERIFY(import.escapeClosesListAlone(u"importTarget"_s));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!import.dialog().isVisible());
    }
};

QTEST_MAIN(TestImportDialog)
#include "tst_import_dialog.moc"
