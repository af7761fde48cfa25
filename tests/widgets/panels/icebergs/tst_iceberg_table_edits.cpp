#include "core/io/files/scenario_json.h"
#include "tests/support/approx.h"
#include "tests/support/flight/mission_builder.h"
#include "tests/support/window/table_fixture.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using berg::test::col;
using berg::test::Ids;
using berg::test::kEditorColumns;
using test::TableFixture;
/** Edits in the table before take-off. */
class TestIcebergTableEdits : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void everyEditIsOneUndoStep_data()
    {
        QTest::addColumn<IcebergColumn>("column");
        QTest::addColumn<QVariant>("value");
        QTest::addColumn<QString>("undoText");
        QTest::newRow("name") << IcebergColumn::Name << QVariant(u"Ny"_s) << u"Change name"_s;
        QTest::newRow("east") << IcebergColumn::East << QVariant(-12.5) << u"Change position"_s;
        QTest::newRow("north") << IcebergColumn::North << QVariant(99.0) << u"Change position"_s;
        QTest::newRow("speed") << IcebergColumn::Speed << QVariant(0.5) << u"Change drift"_s;
        QTest::newRow("direction")
            << IcebergColumn::Direction << QVariant(45.0) << u"Change drift"_s;
        QTest::newRow("sigma0") << IcebergColumn::Sigma0 << QVariant(7.5)
                                << u"Change uncertainty σ₀"_s;
        QTest::newRow("growth") << IcebergColumn::Growth << QVariant(0.1) << u"Change growth q"_s;
        QTest::newRow("observed") << IcebergColumn::Observed << QVariant(60.0)
                                  << u"Change last seen"_s;
        QTest::newRow("appears") << IcebergColumn::Appears << QVariant(30.0)
                                 << u"Change appears at"_s;
    }

    void everyEditIsOneUndoStep()
    {
        QFETCH(IcebergColumn, column);
        QFETCH(QVariant, value);
        QFETCH(QString, undoText);
        TableFixture f;
        QVERIFY(f.put(0, column, value));
        QCOMPARE(f.document.undoStack()->count(), 1);
        QCOMPARE(f.undoText(), undoText);
        const QVariant edited = f.model.index(0, col(column)).data(Qt::EditRole);
        if (column == IcebergColumn::Name)
            QCOMPARE(edited, value);
        else
            COMPARE_NEAR(edited.toDouble(), value.toDouble(), 1e-12); // drift is turned
        QVERIFY(f.document.issues().empty() ||
                f.document.issues().front().severity != Severity::Error);
        f.document.undoStack()->undo();
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        QCOMPARE(f.document.undoStack()->index(), 0);
    }

    void editsKeepToTheLimits()
    {
        TableFixture f;
        f.put(0, IcebergColumn::East, 1e9);
        QCOMPARE(f.icebergs()[0].position_m.x(), kLargestCoordinate_m);
        f.put(0, IcebergColumn::Sigma0, -4);
        QCOMPARE(f.icebergs()[0].sigma0_m2, 0.0);
        f.put(0, IcebergColumn::Speed, 50);
        QVERIFY(f.icebergs()[0].velocity_mps.cwiseAbs().maxCoeff() <= kLargestVelocity_mps);
        const int steps = f.document.undoStack()->count();
        f.put(0, IcebergColumn::Sigma0, 0); // as it is
        QCOMPARE(f.document.undoStack()->count(), steps);
    }

    void oneStepSetsManyRows()
    {
        TableFixture f;
        QVERIFY(f.model.setAll({0, 2, 3}, IcebergColumn::Growth, 0.5));
        QCOMPARE(f.document.undoStack()->count(), 1);
        QCOMPARE(f.icebergs()[0].q_m2ps, 0.5);
        QCOMPARE(f.icebergs()[1].q_m2ps, test::fourIcebergs().icebergs[1].q_m2ps);
        QCOMPARE(f.icebergs()[2].q_m2ps, 0.5);
        QCOMPARE(f.icebergs()[3].q_m2ps, 0.5);
        f.document.undoStack()->undo();
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
    }

    /** Drift east and north is shown and edited; entering the value shown changes nothing. */
    void driftAsComponents()
    {
        const test::UnitsInUse units(test::kComponents);
        TableFixture f;
        QCOMPARE(f.cell(0, IcebergColumn::DriftEast), u"0.30"_s);
        QCOMPARE(f.cell(2, IcebergColumn::DriftNorth), u"0.00"_s);
        for (const IcebergColumn column : {IcebergColumn::DriftEast, IcebergColumn::DriftNorth})
            QVERIFY(f.put(0, column, f.model.index(0, col(column)).data(Qt::EditRole)));
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        QVERIFY(f.put(0, IcebergColumn::DriftNorth, 0.5));
        QCOMPARE(f.icebergs()[0].velocity_mps, Point(0.3, 0.5));
    }

    void pasteIsOneUndoStep()
    {
        TableFixture f;
        f.model.sort(col(IcebergColumn::East), Qt::DescendingOrder); // berg-4, 2, 1, 3
        const PasteOutcome outcome =
            f.model.paste(u"1\n2\n3\n4\n5"_s, 1, col(IcebergColumn::Sigma0), kEditorColumns);
        QCOMPARE(outcome.fault, QString());
        QCOMPARE(f.icebergs().size(), std::size_t{6});
        QCOMPARE(f.icebergs()[1].sigma0_m2, 1.0); // down the rows as they are shown
        QCOMPARE(f.icebergs()[0].sigma0_m2, 2.0);
        QCOMPARE(f.icebergs()[2].sigma0_m2, 3.0);
        QCOMPARE(f.icebergs()[5].sigma0_m2, 5.0);
        QCOMPARE(f.document.undoStack()->count(), 1);
        QCOMPARE(f.undoText(), u"Paste icebergs"_s);
        f.document.undoStack()->undo();
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        QCOMPARE(f.model.rowCount(), 4);
    }

    /** A changed number in a copy is pasted, although the angles beside it are unchanged. */
    void changedCellOfACopyCounts()
    {
        TableFixture f;
        QString text = f.model.copied(f.allRows(), kEditorColumns);
        text.replace(u"berg-1\t2000\t"_s, u"berg-1\t2500\t"_s);
        const PasteOutcome outcome = f.model.paste(text, 0, 0, kEditorColumns);
        QCOMPARE(outcome.fault, QString());
        Scenario wanted = test::fourIcebergs();
        wanted.icebergs[0].position_m.x() = 2500;
        QCOMPARE(f.document.scenario(), wanted);
    }

    /** Angles with many leading zeros are copied and pasted. */
    void anglesNearZeroComeOver()
    {
        const Scenario scenario = test::changed([](Scenario& s) {
            s.origin = {.latitude_deg = 0.001, .longitude_deg = 0};
            s.icebergs[0].position_m = Point(1.0 / 3, 5.0 / 7);
            s.icebergs[1].position_m = Point(-1e-9 / 7, 0);
        });
        TableFixture f(scenario);
        const QString all = f.model.copied(f.allRows(), kEditorColumns);
        const QString angles = f.model.copied(
            f.allRows(), {col(IcebergColumn::Latitude), col(IcebergColumn::Longitude)});
        for (const QString& text : {all, angles}) {
            f.document.edit(u"delete"_s, [](Scenario& s) { s.icebergs.clear(); });
            QCOMPARE(f.model.paste(text, 0, 0, kEditorColumns).fault, QString());
            QCOMPARE(f.icebergs().size(), scenario.icebergs.size());
            for (std::size_t i = 0; i < scenario.icebergs.size(); ++i) {
                const Point off_m = f.icebergs()[i].position_m - scenario.icebergs[i].position_m;
                // 1e-15 degrees; rounding of the projection
                COMPARE_NEAR(off_m.norm(), 0, text == all ? 0 : 1e-7);
            }
        }
    }

    /** Angles are shown to 2 m: typing the angle shown moves only icebergs with another one. */
    void angleAsShownMovesNothing()
    {
        TableFixture f;
        for (const IcebergColumn column : {IcebergColumn::Latitude, IcebergColumn::Longitude})
            QVERIFY(f.put(0, column, f.cell(0, column)));
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        QVERIFY(
            f.model.setAll({0, 1}, IcebergColumn::Latitude, f.cell(0, IcebergColumn::Latitude)));
        QCOMPARE(f.icebergs()[0].position_m, test::fourIcebergs().icebergs[0].position_m);
        QCOMPARE(f.cell(1, IcebergColumn::Latitude), f.cell(0, IcebergColumn::Latitude));
    }

    /** Several icebergs accept one angle; a whole coordinate would move all to one point. */
    void wholePlaceIsForOneOnly()
    {
        for (const QString& text : {u"47.1 N 48.2 W"_s, u"Hibernia"_s}) {
            TableFixture f;
            QSignalSpy edits(&f.model, &IcebergTableModel::edited);
            QVERIFY(!f.model.setAll({0, 1}, IcebergColumn::Latitude, text));
            QVERIFY(edits.back()[0].toString().startsWith(u"Enter one angle only:"_s));
            QCOMPARE(f.document.scenario(), test::fourIcebergs());
            QVERIFY(f.model.setAll({0}, IcebergColumn::Latitude, text));
            QVERIFY(f.model.setAll({0, 1}, IcebergColumn::Latitude, u"47.2 N"_s));
        }
    }

    void brokenCellChangesNothing()
    {
        TableFixture f;
        const PasteOutcome outcome = f.model.paste(u"1\t2\n3\tfar\n5\t6\n7\t8\n9\t10"_s, 0,
                                                   col(IcebergColumn::East), kEditorColumns);
        QVERIFY(outcome.fault.contains(u"far"_s));
        QCOMPARE(f.document.scenario(), test::fourIcebergs());
        QCOMPARE(f.document.undoStack()->count(), 0);
    }

    void copyAndPasteRoundTrip_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::newRow("C") << QLocale::c();
        QTest::newRow("de_DE") << QLocale(QLocale::German, QLocale::Germany);
        QTest::newRow("nb_NO") << QLocale(QLocale::NorwegianBokmal, QLocale::Norway);
    }

    /** Onto the same icebergs nothing changes, not the last bit; elsewhere all numbers come over.
     */
    void copyAndPasteRoundTrip()
    {
        QFETCH(QLocale, locale);
        const Scenario scenario = test::changed([](Scenario& s) {
            s.icebergs[0].position_m = Point(1.0 / 3, -2e5 / 7);
            s.icebergs[0].q_m2ps = 1e-7 / 3;
            s.icebergs[1].velocity_mps = Point(-0.1, 1.0 / 7);
            s.icebergs[3].appears_s = 12345678.9;
        });
        TableFixture f(scenario, locale);
        const QString text = f.model.copied(f.allRows(), kEditorColumns);
        QCOMPARE(text.count(u'\n'), 6); // titles, four icebergs, and a name of two lines
        // In whatever column the cursor is: titles come along.
        PasteOutcome outcome = f.model.paste(text, 0, col(IcebergColumn::North), kEditorColumns);
        QCOMPARE(outcome.fault, QString());
        QCOMPARE(f.document.undoStack()->count(), 0);
        QCOMPARE(f.document.scenario(), scenario);

        const std::vector<std::string> none;
        f.document.edit(u"delete"_s, [](Scenario& s) { s.icebergs.clear(); });
        outcome = f.model.paste(text, 0, 0, kEditorColumns);
        QCOMPARE(outcome.fault, QString());
        QCOMPARE(f.icebergs().size(), scenario.icebergs.size());
        for (std::size_t i = 0; i < f.icebergs().size(); ++i) {
            const Iceberg& before = scenario.icebergs[i];
            const Iceberg& after = f.icebergs()[i];
            QCOMPARE(after.position_m, before.position_m);
            QCOMPARE(after.sigma0_m2, before.sigma0_m2);
            QCOMPARE(after.q_m2ps, before.q_m2ps);
            QCOMPARE(after.observed_s, before.observed_s);
            QCOMPARE(after.appears_s, before.appears_s);
            // rounding by speed and direction
            COMPARE_NEAR((after.velocity_mps - before.velocity_mps).norm(), 0.0, 1e-15);
        }
    }
};

QTEST_MAIN(TestIcebergTableEdits)
#include "tst_iceberg_table_edits.moc"
