#include "core/scenario/utc_time.h"
#include "tests/support/window/import_dialog_test.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

#include <QClipboard>
#include <QStatusBar>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

Scenario started()
{
    Scenario scenario = test::MapFixture::fourIcebergs();
    scenario.startUtc = "2026-06-01T12:00:00Z";
    return scenario;
}

/** A line of a table: who was seen where, so many seconds after the start. */
QString line(const Scenario& scenario, const char* id, const Point& place_m, double after_s)
{
    const LatLon place = LocalFrame(scenario.origin).toGeographic(place_m);
    const std::string time = utcText(*parseUtc(scenario.startUtc), after_s);
    return u"%1,%2,%3,%4\n"_s.arg(QLatin1String(id), QString::fromStdString(time))
        .arg(place.latitude_deg, 0, 'f', 6)
        .arg(place.longitude_deg, 0, 'f', 6);
}

const QString kHeader = u"id,time,lat,lon\n"_s;

void flyTo(WindowFixture& w, double time_s)
{
    w.workspace.fly(100);
    QVERIFY(w.until([&] { return w.record().now.time_s > time_s; }));
    w.workspace.pause();
    QVERIFY(w.until(RunPhase::Paused));
}

/** A person who waits for the preview and presses Report. */
std::optional<ImportChoice> accept(ImportRunner& runner, const ImportOffer& offer)
{
    ImportDialog dialog(runner, offer);
    if (!QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000))
        qFatal("no preview");
    return dialog.choice();
}

std::size_t reportsTaken(WindowFixture& w)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(w.record().history.events, &MissionEvent::reported));
}

} // namespace

/** Sightings that come in by radio while the flight is under way. */
class TestMainWindowReports : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** A known iceberg was seen at the reported time; an unknown one appears at the reported place.
     */
    void arePastedIntoTheFlight()
    {
        WindowFixture w(started());
        w.interaction.importAnswer = accept;
        flyTo(w, 150);
        const double now_s = w.record().now.time_s;
        const double sigma_m2 = w.record().now.world.tracks[3].sigma_m2;
        QApplication::clipboard()->setText(kHeader +
                                           line(w.scenario(), "berg-4", {3460, 3120}, now_s - 60) +
                                           line(w.scenario(), "growler", {-2000, 500}, now_s));
        w.trigger(u"pasteAction"_s);
        QVERIFY(w.until([&] { return reportsTaken(w) == 2; }));
        QCOMPARE(w.record().now.icebergs.size(), std::size_t{5});
        QCOMPARE(w.record().now.icebergs[4].id, std::string("growler"));
        QVERIFY((w.record().now.icebergs[4].position_m - Point(-2000, 500)).norm() < 1);
        const Track& known = w.record().now.world.tracks[3];
        QVERIFY(sigma_m2 > 60 * known.q_m2ps);
        QCOMPARE(known.sigma_m2, 60 * known.q_m2ps);
        QVERIFY(w.window().statusBar()->currentMessage().contains(u"Reported 2 icebergs"_s));
        QCOMPARE(w.record().now.time_s, now_s);
    }

    /** The dialog offers what can be done in flight, which pauses for it and then goes on. */
    void pauseTheFlight()
    {
        WindowFixture w(started());
        bool isNamed = false;
        bool isPaused = false;
        w.interaction.importAnswer = [&](ImportRunner& runner, const ImportOffer& offer) {
            ImportDialog dialog(runner, offer);
            dialog.show();
            isPaused = !w.workspace.isPlaying();
            isNamed = test::child<QPushButton>(dialog, u"importButton"_s).text() == u"Re&port"_s &&
                      !test::child<QComboBox>(dialog, u"importTarget"_s).isVisible();
            return std::optional<ImportChoice>();
        };
        w.workspace.fly(1);
        QVERIFY(w.until([&] { return w.record().now.time_s > 1; }));
        QApplication::clipboard()->setText(kHeader + line(w.scenario(), "x", {0, 500}, 0));
        w.trigger(u"pasteAction"_s);
        QVERIFY(w.until([&] { return isNamed; }));
        QVERIFY(isPaused);
        QVERIFY(w.until([&] { return w.workspace.isPlaying(); }));
        QCOMPARE(reportsTaken(w), std::size_t{0});
    }

    /** Later than the flight: it is left out, as what has not happened. */
    void ofTheFutureAreLeftOut()
    {
        WindowFixture w(started());
        w.interaction.importAnswer = accept;
        flyTo(w, 100);
        const double now_s = w.record().now.time_s;
        QApplication::clipboard()->setText(kHeader +
                                           line(w.scenario(), "berg-4", {3460, 3120}, now_s + 600) +
                                           line(w.scenario(), "growler", {-2000, 500}, now_s - 10));
        w.trigger(u"pasteAction"_s);
        QVERIFY(w.until([&] { return reportsTaken(w) == 1; }));
        QCOMPARE(w.record().now.icebergs.size(), std::size_t{5});
    }

    /** Before take-off a table on the clipboard is imported as a file of it is. */
    void tablesArePastedBeforeTakeOff()
    {
        WindowFixture w(started());
        w.interaction.importAnswer = accept;
        QApplication::clipboard()->setText(kHeader +
                                           line(w.scenario(), "growler", {-2000, 500}, 0));
        w.trigger(u"pasteAction"_s);
        QCOMPARE(w.scenario().icebergs.size(), std::size_t{5});
        QCOMPARE(w.document().undoStack()->count(), 1);
    }
};

QTEST_MAIN(TestMainWindowReports)
#include "tst_main_window_reports.moc"
