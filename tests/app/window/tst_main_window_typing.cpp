#include "core/presets/presets.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/fields/number_field.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** The window with the inspector in front. */
struct TypingFixture : WindowFixture
{
    explicit TypingFixture(const QString& selected = {})
        : WindowFixture(test::MapFixture::fourIcebergs())
    {
        if (!selected.isEmpty())
            workspace.selection().set({selected.toStdString()});
        window().findChild<QDockWidget*>(u"inspectorDock"_s)->raise();
        QTest::qWait(0);
    }
    template <class Input = NumberField>
    [[nodiscard]] Input& input(const QString& name)
    {
        return test::child<Input>(window(), name);
    }
    [[nodiscard]] QString remark(const QString& name)
    {
        const auto& label = input<QLabel>(name + u"Fault"_s);
        return label.isVisible() ? label.text() : QString();
    }
};

} // namespace

/** Typed input in the usual notations. */
class TestMainWindowTyping : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void durationsWithUnits_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("endurance_s");
        QTest::addColumn<QString>("shown");
        QTest::newRow("minutes") << u"45 min"_s << 2700.0 << u"45 min"_s;
        QTest::newRow("clock") << u"0:45"_s << 2700.0 << u"45 min"_s;
        QTest::newRow("with seconds") << u"0:16:40"_s << 1000.0 << u"0:16:40"_s;
        QTest::newRow("hours") << u"2 h"_s << 7200.0 << u"120 min"_s;
        QTest::newRow("seconds") << u"1000 s"_s << 1000.0 << u"0:16:40"_s;
    }

    /** The space is of the field: nothing takes off, and the letters after it take no tool. */
    void durationsWithUnits()
    {
        QFETCH(QString, typed);
        QFETCH(double, endurance_s);
        QFETCH(QString, shown);
        TypingFixture w(u"uav-1"_s);
        auto& endurance = w.input(u"uavs.endurance_s"_s);
        test::enter(endurance, typed);
        QCOMPARE(w.scenario().uavs.front().spec.endurance_s, endurance_s);
        QCOMPARE(endurance.text(), shown);
        QVERIFY(!w.workspace.inFlight());
        QCOMPARE(w.map().tools().kind(), MapToolKind::Select);
        QCOMPARE(w.remark(u"uavs.endurance_s"_s), QString());
    }

    /** A number alone is in the unit that is shown. */
    void aNumberAloneKeepsTheUnit()
    {
        TypingFixture w(u"uav-1"_s);
        auto& endurance = w.input(u"uavs.endurance_s"_s);
        test::enter(endurance, u"45 min"_s);
        test::enter(endurance, u"50"_s);
        QCOMPARE(w.scenario().uavs.front().spec.endurance_s, 3000.0);
        QCOMPARE(endurance.text(), u"50 min"_s);
    }

    void speedsAndLengths()
    {
        TypingFixture w;
        auto& wind = w.input(u"scenarioWindSpeed"_s);
        test::enter(wind, u"15 kn"_s);
        QCOMPARE(wind.text(), u"7.72 m/s"_s);
        QVERIFY(std::abs(w.scenario().wind_mps.norm() - 15 * 1852.0 / 3600) < 0.01); // rounded
        w.workspace.selection().set({"uav-1"});
        test::enter(w.input(u"uavs.altitude_m"_s), u"400 ft"_s);
        QVERIFY(std::abs(w.scenario().uavs.front().spec.altitude_m - 121.92) < 0.05); // rounded
        test::enter(w.input(u"uavEast"_s), u"1.5 nmi"_s);
        QCOMPARE(w.scenario().uavs.front().position_m.x(), 2778.0);
        QVERIFY(!w.workspace.inFlight());
    }

    /** In words that stay, beside the field. */
    void whatIsNotSetIsSaid()
    {
        TypingFixture w(u"uav-1"_s);
        auto& bank = w.input(u"uavs.max_bank_deg"_s);
        const QString before = bank.text();
        test::enter(bank, u"steep"_s);
        QCOMPARE(bank.text(), before);
        QVERIFY(w.remark(u"uavs.max_bank_deg"_s).contains(u"steep"_s));
        test::enter(bank, u"500"_s);
        QVERIFY(bank.text() != before);
        QVERIFY(w.remark(u"uavs.max_bank_deg"_s).contains(u"500"_s) &&
                w.remark(u"uavs.max_bank_deg"_s).contains(bank.text()));
        QTest::keyClicks(&bank, u"2"_s); // it is read, and something else is typed
        QCOMPARE(w.remark(u"uavs.max_bank_deg"_s), QString());
        test::enter(bank, u"500"_s);
        w.workspace.selection().set({"berg-1"});
        w.workspace.selection().set({"uav-1"});
        QCOMPARE(w.remark(u"uavs.max_bank_deg"_s), QString());
    }

    /** In flight they are locked, and yet what is typed does not steer the flight. */
    void lockedFieldsKeepTheirKeys()
    {
        TypingFixture w(u"uav-1"_s);
        auto& endurance = w.input(u"uavs.endurance_s"_s);
        endurance.setFocus();
        w.workspace.fly(1);
        QVERIFY(w.until([&] { return w.workspace.inFlight(); }));
        QTRY_COMPARE(QApplication::focusWidget(), &w.map()); // Space pauses
        endurance.setFocus();
        QTest::keyClicks(&endurance, u"45 min"_s);
        QVERIFY(w.workspace.isPlaying());
        QCOMPARE(w.map().tools().kind(), MapToolKind::Select);
    }

    void startsAreReadAsByTheImport_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("start"); // empty if the input is rejected with a reason
        QTest::newRow("minutes") << u"2026-11-29 12:00"_s << u"2026-11-29T12:00:00Z"_s;
        QTest::newRow("name of the month") << u"29 Nov 2026 12:00"_s << u"2026-11-29T12:00:00Z"_s;
        QTest::newRow("time alone") << u"1200Z"_s << u"2026-05-01T12:00:00Z"_s;
        QTest::newRow("offset") << u"2026-11-29 12:00 +0100"_s << u"2026-11-29T11:00:00Z"_s;
        QTest::newRow("two readings") << u"03/04/2026 12:00"_s << QString();
        QTest::newRow("words") << u"tomorrow"_s << QString();
    }

    void startsAreReadAsByTheImport()
    {
        QFETCH(QString, typed);
        QFETCH(QString, start);
        TypingFixture w;
        auto& line = w.input<QLineEdit>(u"start_utc"_s);
        test::enter(line, u"1200Z"_s);
        QVERIFY(w.remark(u"start_utc"_s).contains(u"1200Z"_s)); // of which day?
        test::enter(line, u"2026-05-01T06:00:00Z"_s);
        QCOMPARE(w.remark(u"start_utc"_s), QString());
        test::enter(line, typed);
        QCOMPARE(w.remark(u"start_utc"_s).isEmpty(), !start.isEmpty());
        QCOMPARE(QString::fromStdString(w.scenario().startUtc),
                 start.isEmpty() ? u"2026-05-01T06:00:00Z"_s : start);
        QVERIFY(!w.workspace.inFlight());
    }
};

QTEST_MAIN(TestMainWindowTyping)
#include "tst_main_window_typing.moc"
