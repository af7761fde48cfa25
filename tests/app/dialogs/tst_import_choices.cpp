#include "tests/support/window/import_dialog_test.h"

#include <QRadioButton>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::Importing;
using test::written;

/** Questions and consents of the dialog that imports sightings. */
class TestImportChoices : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Rows without ids are what the user says they are; until he does there is no import. */
    void oneIcebergOrMany()
    {
        QTemporaryDir folder;
        const QString path =
            written(folder.filePath(u"beacon.csv"_s), "time,lat,lon\n2024-05-01T00:00:00Z,60,-50\n"
                                                      "2024-05-01T01:00:00Z,60.01,-50\n");
        Importing import(path);
        QVERIFY(import.settles());
        QVERIFY(import.at<QLabel>(u"importQuestion"_s).isVisible());
        QVERIFY(!import.canImport());
        QVERIFY(!import.dialog().choice());
        QVERIFY(!import.at<QPushButton>(u"importNewButton"_s).isVisible());
        for (const QString& name : {u"importIdentity0"_s, u"importIdentity1"_s})
            QVERIFY(!import.at<QRadioButton>(name).isChecked());
        import.at<QRadioButton>(u"importIdentity0"_s).click();
        QVERIFY(import.settles());
        QVERIFY(import.canImport());
        QCOMPARE(import.dialog().choice()->scenario.icebergs.size(), 1U);
        import.at<QRadioButton>(u"importIdentity1"_s).click();
        QVERIFY(import.settles());
        QCOMPARE(import.dialog().choice()->scenario.icebergs.size(), 2U);
        QVERIFY(import.at<QRadioButton>(u"importIdentity1"_s).isChecked());
        QVERIFY(import.at<QLabel>(u"importQuestion"_s).isVisible()); // to answer otherwise
    }

    /** Each column that may hold ids, with what it would give. */
    void columnsThatMayHoldIds()
    {
        QTemporaryDir folder;
        const QString path = written(
            folder.filePath(u"five.csv"_s),
            "call,time,lat,lon\nX,2024-05-01T00:00:00Z,60,-50\nY,2024-05-01T00:30:00Z,61,-50\n"
            "X,2024-05-01T01:00:00Z,60.01,-50\nY,2024-05-01T01:30:00Z,61.01,-50\n");
        Importing import(path);
        QVERIFY(import.settles());
        auto& call = import.at<QRadioButton>(u"importIdentity0"_s);
        QVERIFY(call.text().contains(u"call"_s));
        QCOMPARE(call.accessibleDescription(),
                 u"2 icebergs, up to %1 m/s between sightings"_s.arg(QLocale().toString(0.31)));
        QVERIFY(import.at<QRadioButton>(u"importIdentity2"_s).isVisible());
        call.click();
        QVERIFY(import.settles());
        const Scenario scenario = import.dialog().choice()->scenario;
        QCOMPARE(scenario.icebergs.size(), 2U);
        QCOMPARE(scenario.icebergs[0].id, std::string("X"));
        import.choose(u"column-id"_s, 1); // the same by hand: nothing is left to ask
        QVERIFY(import.settles());
        QVERIFY(!import.at<QLabel>(u"importQuestion"_s).isVisible());
        QVERIFY(import.dialog().choice()->scenario == scenario);
    }

    /** An iceberg on land, or faster than any, is taken only when the user says so. */
    void doubtfulIcebergsNeedConsent()
    {
        QTemporaryDir folder;
        Importing import(
            written(folder.filePath(u"land.csv"_s), "id,lat,lon\na,48.7,-56\nb,47,-48\n"));
        QVERIFY(import.settles());
        auto& consent = import.at<QCheckBox>(u"importConsent"_s);
        QVERIFY(consent.isVisible());
        QVERIFY(!consent.isChecked());
        QVERIFY(!import.canImport());
        QVERIFY(!import.dialog().choice());
        QVERIFY(import.at<QLabel>(u"importScene"_s).text().contains(u"on land: a."_s));
        consent.click();
        QVERIFY(import.canImport());
        QCOMPARE(import.dialog().choice()->scenario.icebergs.size(), 2U);
        import.choose(u"importTarget"_s, 1); // another result, another consent
        QVERIFY(import.settles());
        QVERIFY(!import.canImport());
        import.check(u"importAreaBox"_s);
        test::enter(import.at<QWidget>(u"importEdge1"_s), u"-50"_s);
        QVERIFY(import.settles());
        QVERIFY(!consent.isVisible());
        QVERIFY(import.canImport());
    }

    /** The error of a source is set with it, and may be typed. */
    void positionErrorBySource()
    {
        QTemporaryDir folder;
        Importing import(written(folder.filePath(u"seen.csv"_s), "id,lat,lon\na,60,-50\n"));
        QVERIFY(import.settles());
        const auto sd_m = [&] {
            return std::sqrt(import.dialog().choice()->scenario.icebergs.at(0).sigma0_m2);
        };
        QCOMPARE(sd_m(), 20.0);
        auto& sources = import.at<QComboBox>(u"importSource"_s);
        for (const SightingSource source : kSightingSources) {
            import.choose(u"importSource"_s, sources.findData(static_cast<int>(source)));
            QVERIFY(import.settles());
            QCOMPARE(sd_m(), errorOf(source).sd_m);
        }
        test::enter(import.at<QWidget>(u"importPositionError"_s), u"77"_s);
        QVERIFY(import.settles());
        QCOMPARE(sd_m(), 77.0);
        QCOMPARE(sources.currentText(), u"As typed"_s);
        import.choose(u"importSource"_s, 0);
        QVERIFY(import.settles());
        QCOMPARE(sd_m(), 20.0);
    }
};

QTEST_MAIN(TestImportChoices)
#include "tst_import_choices.moc"
