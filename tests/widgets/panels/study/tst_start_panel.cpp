#include "core/presets/presets.h"
#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/charts/start_chart.h"
#include "widgets/document/scenario_document.h"
#include "widgets/panels/fields/number_field.h"
#include "widgets/panels/study/start_panel.h"
#include "widgets/words/weather_words.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QUndoStack>

using namespace berg;
using namespace Qt::StringLiterals;
using test::kPatience_ms;

namespace {

Scenario shortDay()
{
    Scenario scenario = randomScenario(2, {.icebergs = 3});
    scenario.duration_s = 120;
    scenario.planner.policy = PolicyKind::Nearest;
    scenario.startUtc = "2026-05-01T12:00:00Z";
    scenario.wind_mps = {9, 0};
    scenario.uavs[0].weather.wind_mps = 10;
    return scenario;
}

struct StartPanelFixture
{
    StartRunner runner;
    ScenarioDocument document;
    StartPanel panel{runner, document};
    QPushButton& compare = test::child<QPushButton>(panel, u"compareStarts"_s);
    QPushButton& use = test::child<QPushButton>(panel, u"useStart"_s);
    QLabel& state = test::child<QLabel>(panel, u"startState"_s);
    QProgressBar& bar = test::child<QProgressBar>(panel, u"startProgress"_s);
    StartChart& chart = test::child<StartChart>(panel, u"startChart"_s);

    explicit StartPanelFixture(const Scenario& scenario)
    {
        document.reset(scenario);
        test::child<NumberField>(panel, u"startSpan"_s).setValue(2);
        panel.resize(820, 460);
        panel.show();
    }
    [[nodiscard]] bool ends() const
    {
        return QTest::qWaitFor([this] { return !runner.isRunning(); }, kPatience_ms);
    }
};

} // namespace

class TestStartPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { test::failOnWarnings(); }

    void startsAreComparedAndOneIsUsed()
    {
        StartPanelFixture f(shortDay());
        QVERIFY(!f.use.isEnabled());
        f.compare.click();
        QVERIFY(f.bar.isVisible());
        QVERIFY(f.ends());
        QVERIFY(f.runner.scan());
        QVERIFY(!f.bar.isVisible());
        QCOMPARE(f.runner.scan()->starts.size(), std::size_t{3});
        QCOMPARE(f.chart.chosen(), f.runner.scan()->best);
        QVERIFY2(
            f.state.text().contains(u"Marginal: wind 9.00 m/s, limit 10.0 m/s, from 12:00 UTC"_s),
            qPrintable(f.state.text()));
        emit f.chart.itemActivated(2);
        QVERIFY(f.use.isEnabled());
        f.use.click();
        QCOMPARE(f.document.scenario().startUtc, std::string("2026-05-01T14:00:00Z"));
        QVERIFY(f.document.scenario() == startingLater(shortDay(), 7200));
        QCOMPARE(f.document.undoStack()->count(), 1);
        QVERIFY(!f.use.isEnabled()); // the comparison was of another start
        QVERIFY(f.state.text().contains(u"changed since"_s));
        f.document.undo();
        QVERIFY(f.document.scenario() == shortDay());
    }

    void comparisonCanBeCancelled()
    {
        Scenario scenario = shortDay();
        scenario.duration_s = 36000;
        StartPanelFixture f(scenario);
        f.compare.click();
        QCOMPARE(f.compare.text(), u"Cancel"_s);
        f.compare.click();
        QVERIFY(f.ends());
        QCOMPARE(f.compare.text(), u"Compare"_s);
        QVERIFY(!f.runner.scan());
        QCOMPARE(f.state.text(), u"Cancelled."_s);
    }

    void startIsNeeded()
    {
        Scenario scenario = shortDay();
        scenario.startUtc.clear();
        StartPanelFixture f(scenario);
        QVERIFY(!f.compare.isEnabled());
        QVERIFY(f.state.text().contains(u"no start time"_s));
    }

    void verdictInWords()
    {
        Scenario scenario = shortDay();
        const auto verdict = [&scenario](const WeatherReason& reason) {
            WeatherVerdict weather{.uavs = {{.state = reason.state, .reason = reason}}};
            return weatherText(scenario, weather, QLocale::c());
        };
        QCOMPARE(weatherText(scenario, {.uavs = {{}}}, QLocale::c()), u"Go"_s);
        QCOMPARE(verdict({.of = WeatherLimit::Gust,
                          .state = WeatherState::Unknown,
                          .limit = 12,
                          .time_s = 90}),
                 u"Not known: gusts not known, limit 12.0 m/s, from 12:01 UTC"_s);
        scenario.startUtc.clear();
        QCOMPARE(verdict({.of = WeatherLimit::Icing, .time_s = 90}), u"No-go: icing, from 01:30"_s);
        scenario.uavs.push_back({.id = "uav-2"});
        scenario.uavs[0].name = "First";
        QVERIFY(verdict({.of = WeatherLimit::Icing}).startsWith(u"No-go: First, icing"_s));
    }
};

QTEST_MAIN(TestStartPanel)
#include "tst_start_panel.moc"
