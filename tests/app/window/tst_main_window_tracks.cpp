#include "tests/support/approx.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

constexpr double kRounding = 1e-6;

/** Waits for tracks that begin at a time. */
bool tracksBeginAt(WindowFixture& w, double time_s)
{
    return w.until([&] {
        const DriftTracksPointer& tracks = w.map().layers().tracks;
        return tracks && !tracks->empty() && !tracks->front().points.empty() &&
               std::abs(tracks->front().points.front().time_s - time_s) < kRounding;
    });
}

/** Returns the largest distance between the start of a track and its iceberg as it is shown. */
double largestOffset_m(WindowFixture& w)
{
    double largest_m = 0;
    for (const DriftTrack& track : *w.map().layers().tracks) {
        const Point shown_m = w.record().estimate_m(IcebergIndex::of(track.iceberg));
        largest_m = std::max(largest_m, (track.points.front().position_m - shown_m).norm());
    }
    return largest_m;
}

} // namespace

/** Predicted drift and other layers of the map. */
class TestMainWindowTracks : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** In flight they begin where the icebergs are now, and looking back where they were then. */
    void tracksBeginAtTheTimeShown()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        w.trigger(u"driftTracksAction"_s);
        QVERIFY(tracksBeginAt(w, 0));
        w.workspace.stepTicks(qRound(600 / w.scenario().dt_s));
        QVERIFY(w.until([&] {
            return w.record().now.phase == RunPhase::Paused && w.record().now.time_s >= 599;
        }));
        QVERIFY(tracksBeginAt(w, w.record().now.time_s));
        QCOMPARE(w.map().layers().tracks->size(), std::size_t{4});
        QVERIFY(largestOffset_m(w) < kRounding);
        w.workspace.seek(200);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        QVERIFY(tracksBeginAt(w, w.record().shown().time_s));
        QVERIFY(largestOffset_m(w) < kRounding);
        w.workspace.reset();
        QVERIFY(tracksBeginAt(w, 0));
    }

    /** The ice chart is faint by default; the tracks are hidden. */
    void layersComeBackWithTheirUsualStrength()
    {
        WindowFixture w(test::MapFixture::fourIcebergs());
        const auto opacity = [&](MapLayer layer) { return w.map().layers().opacity(layer); };
        const double usual = opacity(MapLayer::IceChart);
        QVERIFY(usual > 0 && usual < 1);
        QVERIFY(w.action(u"iceChartLayerAction"_s).isChecked());
        w.trigger(u"iceChartLayerAction"_s);
        QCOMPARE(opacity(MapLayer::IceChart), 0.0);
        w.trigger(u"iceChartLayerAction"_s);
        QCOMPARE(opacity(MapLayer::IceChart), usual);
        w.trigger(u"driftTracksAction"_s);
        QCOMPARE(opacity(MapLayer::Tracks), 1.0);
    }
};

QTEST_MAIN(TestMainWindowTracks)
#include "tst_main_window_tracks.moc"
