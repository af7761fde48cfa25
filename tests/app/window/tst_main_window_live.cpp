#include "core/io/files/run_json.h"
#include "core/presets/presets.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/panels/flight/run_time_line.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** Long enough for hands to do something meanwhile, however fast it is flown. */
Scenario longMission()
{
    Scenario scenario = defaultScenario();
    scenario.duration_s = 4 * 3600;
    return scenario;
}

/** To these shares of the time line, one after the other. */
void scrub(WindowFixture& w, const std::vector<double>& shares)
{
    auto& line = test::child<RunTimeLine>(w.window(), u"timeLine"_s);
    const auto at = [&](double share) {
        return QPoint(static_cast<int>(share * line.width()), line.height() / 2);
    };
    QTest::mousePress(&line, Qt::LeftButton, {}, at(shares.front()));
    for (const double share : shares)
        QTest::mouseMove(&line, at(share));
    QTest::mouseRelease(&line, Qt::LeftButton, {}, at(shares.back()));
}

bool hasFinished(WindowFixture& w)
{
    return w.record().now.phase == RunPhase::Finished;
}

} // namespace

/** Hands on everything while a mission is flown at full speed; see also `WindowFixture`. */
class TestMainWindowLive : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void anythingMayBeDoneMeanwhile()
    {
        WindowFixture w(longMission());
        w.trigger(u"stepAction"_s);
        QVERIFY(w.until(RunPhase::Paused));
        w.dragTau(0.3, 0.9);
        double tau = 0.9;
        for (int round = 0; !hasFinished(w) && round < 1000; ++round) {
            const double before_s = w.record().now.time_s;
            w.workspace.seekLatest();
            w.workspace.fly(kFastestRate);
            w.dragTau(tau, 1.0 - tau, 5);
            tau = 1.0 - tau;
            w.window().resize(1000 + 40 * (round % 8), 700 + 25 * (round % 5));
            QVERIFY(w.until([&] { return hasFinished(w) || w.record().now.time_s > before_s; }));
            scrub(w, {0.01, 0.02, 0.01});
            QVERIFY(w.until([&] { return hasFinished(w) || w.record().instant.has_value(); }));
        }
        QVERIFY(hasFinished(w));
        w.workspace.seekLatest();
        QVERIFY(!w.record().instant);
        QCOMPARE(w.record().now.time_s, longMission().duration_s);
        QCOMPARE(w.record().history.samples.back().zeta_m2s, w.record().now.metrics.zeta_m2s);

        const std::shared_ptr<const RunFile> run = flownRun(w);
        QVERIFY(!run->interventions.empty());
        const auto [differences, metrics] = test::elsewhere([&] {
            const Mission again = replay(*run);
            return std::pair(compareRun(*run, berg::runOf(again)), again.metrics());
        });
        QVERIFY(differences.empty());
        QVERIFY(metrics == w.record().now.metrics);
    }

    /** A day is recorded so that showing it costs about as much as an hour. */
    void aDayStaysSmall()
    {
        Scenario day = randomScenario(31, {.icebergs = 100});
        day.duration_s = 24 * 3600;
        QCOMPARE(recordingOf(day).sampleInterval_s, 5.0);
        day.planner.policy = PolicyKind::Nearest;
        WindowFixture w(day);
        w.workspace.fly(kFastestRate);
        QVERIFY(w.until(RunPhase::Finished));
        const std::vector<Sample>& samples = w.record().history.samples;
        QCOMPARE(samples.size(), std::size_t{24 * 3600 / 5 + 1});
        const MapPicture picture = missionPicture(w.record(), QLocale::c());
        QVERIFY2(picture.routes[0].track.size() < 4000,
                 QByteArray::number(qulonglong(picture.routes[0].track.size())));
        QVERIFY(picture.routes[0].track.front().position_m ==
                samples.front().uavs[0].pose.position_m);
        for (std::size_t i = 0; i < 500; ++i) // the last stretch is all there
            QVERIFY(picture.routes[0].track.rbegin()[static_cast<std::ptrdiff_t>(i)].position_m ==
                    samples.rbegin()[static_cast<std::ptrdiff_t>(i)].uavs[0].pose.position_m);
    }
};

QTEST_MAIN(TestMainWindowLive)
#include "tst_main_window_live.moc"
