#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/panels/plan/plan_model.h"
#include "widgets/theme/unit_settings.h"

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolTip>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario atNoon()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    scenario.startUtc = "2026-11-29T12:00:00Z";
    return scenario;
}

/** Returns a scenario in which an iceberg drifts into the inner ring of a platform. */
Scenario threatenedAtNoon()
{
    Scenario scenario = test::emptySea(40);
    scenario.startUtc = "2026-11-29T12:00:00Z";
    scenario.uavs.front().position_m = {-6000, -4000};
    test::addIceberg(scenario, 2000, 0).velocity_mps = {-0.5, 0};
    scenario.asset = Asset{.name = "Rig", .range_m = 4000, .alarm_m = 1000};
    return scenario;
}

bool flyTo(WindowFixture& w, double time_s)
{
    const double ticks = (time_s - w.record().now.time_s) / w.scenario().dt_s;
    w.workspace.stepTicks(static_cast<int>(std::lround(ticks)));
    return w.until([&] { return w.record().now.time_s >= time_s - 1e-6; });
}

QString timeField(WindowFixture& w)
{
    return test::child<QLineEdit>(w.window(), u"timeField"_s).text();
}

/** The first number of the card on the map. */
QString timeCard(WindowFixture& w)
{
    return missionPicture(w.record(), QLocale::c()).readouts.front().value;
}

void typeTime(WindowFixture& w, const QString& text)
{
    auto& field = test::child<QLineEdit>(w.window(), u"timeField"_s);
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

QString cell(WindowFixture& w, const QString& table, int row, int column,
             int role = Qt::DisplayRole)
{
    const auto* model = test::child<QTableView>(w.window(), table).model();
    return model->index(row, column).data(role).toString();
}

} // namespace

/** Instants of a run that has a start are UTC wherever they are shown. */
class TestMainWindowTimes : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }
    void cleanup() { setShownUnits({}); }

    void everywhereInUtc()
    {
        WindowFixture w(atNoon());
        QTRY_COMPARE(timeField(w), u"12:00:00Z"_s);
        QVERIFY(cell(w, u"planTable"_s, 0, PlanModel::Arrival).startsWith(u"12:"_s));
        QVERIFY(cell(w, u"planTable"_s, 0, PlanModel::Arrival).endsWith(u'Z'));
        const QString tip = cell(w, u"planTable"_s, 0, PlanModel::Arrival, Qt::ToolTipRole);
        QVERIFY2(tip.startsWith(u"in "_s) && tip.contains(u"2026-11-29 12:"_s) &&
                     tip.contains(u"local time"_s),
                 qPrintable(tip));
        QTRY_VERIFY(test::child<QLabel>(w.window(), u"planSummary"_s)
                        .toolTip()
                        .contains(u"flown by 12:"_s));

        QVERIFY(flyTo(w, 90));
        QTRY_COMPARE(timeField(w), u"12:01:30Z"_s);
        QTRY_COMPARE(timeCard(w), u"12:01:30Z"_s);
        QTRY_COMPARE(cell(w, u"eventTable"_s, 0, 0), u"12:00:00Z"_s);
        w.workspace.seek(30);
        QTRY_COMPARE(test::child<QLabel>(w.window(), u"flightState"_s).text(),
                     u"Looking back at 12:00:30Z"_s);
    }

    /** One that shows elapsed times, too. */
    void typedInTheTimeLine()
    {
        WindowFixture w(atNoon());
        QVERIFY(flyTo(w, 90));
        const auto isShownAt = [&w](double time_s) {
            return w.until([&] {
                return w.record().instant && std::abs(w.record().instant->time_s - time_s) < 0.05;
            });
        };
        typeTime(w, u"1201Z"_s);
        QVERIFY(isShownAt(60));
        QTRY_COMPARE(timeField(w), u"12:01:00Z"_s);
        typeTime(w, u"12:00:20Z"_s);
        QVERIFY(isShownAt(20));
        typeTime(w, u"1:10"_s);
        QVERIFY(isShownAt(70));
        typeTime(w, u"1130Z"_s); // before the start
        QVERIFY(isShownAt(70));
        QTRY_COMPARE(timeField(w), u"12:01:10Z"_s);
    }

    void alarmsNameTheTime()
    {
        WindowFixture w(threatenedAtNoon());
        QVERIFY(flyTo(w, 5));
        const auto& line = test::child<QAbstractButton>(w.window(), u"flightNotice1"_s);
        QTRY_VERIFY(line.isVisible());
        // 1000 m at 0.5 m/s from a few seconds after noon.
        QVERIFY2(line.text().endsWith(u"(12:33Z)"_s), qPrintable(line.text()));
    }

    void theMenuChooses()
    {
        WindowFixture w(atNoon());
        QVERIFY(flyTo(w, 90));
        QVERIFY(w.action(u"units/times-utc"_s).isChecked());
        w.trigger(u"units/times-elapsed"_s);
        QTRY_COMPARE(timeField(w), u"01:30"_s);
        QTRY_COMPARE(cell(w, u"eventTable"_s, 0, 0), u"00:00"_s);
        QTRY_VERIFY(cell(w, u"planTable"_s, 0, PlanModel::Arrival).startsWith(u"in "_s));
        QCOMPARE(timeCard(w), u"01:30"_s);
        w.trigger(u"units/times-utc"_s);
        QTRY_COMPARE(timeField(w), u"12:01:30Z"_s);
    }

    void withoutAStartTimesAreElapsed()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QVERIFY(flyTo(w, 90));
        QTRY_COMPARE(timeField(w), u"01:30"_s);
        QVERIFY(cell(w, u"planTable"_s, 0, PlanModel::Arrival).startsWith(u"in "_s));
        QCOMPARE(cell(w, u"planTable"_s, 0, PlanModel::Arrival, Qt::ToolTipRole), QString());
    }

    /** A start that is typed or cleared changes what is shown at once. */
    void theStartIsEdited()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        QTRY_COMPARE(timeField(w), u"00:00"_s);
        w.document().edit(u"Change start"_s,
                          [](Scenario& scenario) { scenario.startUtc = "2026-11-29T12:00:00Z"; });
        QTRY_COMPARE(timeField(w), u"12:00:00Z"_s);
        QVERIFY(w.untilReady());
        QTRY_VERIFY(cell(w, u"planTable"_s, 0, PlanModel::Arrival).endsWith(u'Z'));
    }
};

QTEST_MAIN(TestMainWindowTimes)
#include "tst_main_window_times.moc"
