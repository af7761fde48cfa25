#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/charts/mission_charts.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/map/picture/mission_picture.h"

#include <QMenu>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

/** Two icebergs near the UAV, and two so far away that their uncertainty grows all the time. */
Scenario nearAndFar()
{
    Scenario scenario = test::emptySea(3000);
    test::addIceberg(scenario, 2000, 1500);
    test::addIceberg(scenario, 3000, -1500);
    test::addIceberg(scenario, -9000, 4000);
    test::addIceberg(scenario, -9000, -4000);
    return scenario;
}

/** The symbol of an iceberg in the window, without what lies round it. */
QImage symbolIn(WindowFixture& w, const std::string& id)
{
    constexpr int kInside_px = 5;
    const QPoint at = w.pixelOf(id);
    return w.map()
        .grab({at - QPoint(kInside_px, kInside_px), QSize(2 * kInside_px, 2 * kInside_px)})
        .toImage();
}

bool flyUntil(WindowFixture& w, double time_s)
{
    w.workspace.stepTicks(static_cast<int>((time_s - w.record().now.time_s) / w.scenario().dt_s));
    return w.until([&] {
        return w.record().now.phase == RunPhase::Paused &&
               std::abs(w.record().now.time_s - time_s) < w.scenario().dt_s;
    });
}

/** Returns the colour of a pixel on the screen. */
QPoint placeOnLegend(WindowFixture& w)
{
    constexpr int kStep_px = 20;
    for (int x = 0; x < w.map().width(); x += kStep_px)
        for (int y = 0; y < w.map().height(); y += kStep_px)
            if (const QPoint at = w.map().mapToGlobal(QPoint(x, y));
                w.map().panels().at(w.map().mapFromGlobal(at)) == MapPanel::Legend)
                return at;
    qFatal("no legend");
}

QMenu& sigmaMenu(WindowFixture& w)
{
    for (QAction* action : w.window().findChildren<QAction*>())
        if (action->menu() != nullptr && action->text().contains(u"σ"_s))
            return *action->menu();
    qFatal("no menu of the colour scale");
}

} // namespace

/** The colour of an uncertainty. */
class TestMainWindowColours : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }
    void cleanup() { chooseSigmaEnd(std::nullopt); }

    /** Flown to, looked back at and continued from, an instant has the same colours. */
    void anInstantHasOneColour()
    {
        WindowFixture w(nearAndFar());
        QVERIFY(flyUntil(w, 200));
        const QImage flown = symbolIn(w, "berg-3");
        const double end_m2 = missionPicture(w.record(), QLocale::c()).sigmaFull_m2;
        QVERIFY(flyUntil(w, 2000));
        QVERIFY(symbolIn(w, "berg-3") != flown); // or the test would see nothing
        QCOMPARE(missionPicture(w.record(), QLocale::c()).sigmaFull_m2, end_m2);
        w.workspace.seek(200);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        QCOMPARE(missionPicture(w.record(), QLocale::c()).sigmaFull_m2, end_m2);
        QTRY_VERIFY(symbolIn(w, "berg-3") == flown);
        w.workspace.continueFromHere();
        QVERIFY(w.until([&] { return !w.record().instant && w.record().now.time_s < 201; }));
        QCOMPARE(missionPicture(w.record(), QLocale::c()).sigmaFull_m2, end_m2);
        QTRY_VERIFY(symbolIn(w, "berg-3") == flown);
        QCOMPARE(missionChart(ChartKind::Sigma, w.record(), QLocale::c()).sigmaFull_m2, end_m2);
    }

    /** From the menu, at once, and in the next window as well. */
    void theUserChoosesTheEnd()
    {
        WindowFixture w(nearAndFar());
        QVERIFY(flyUntil(w, 200));
        const QImage own = symbolIn(w, "berg-3");
        w.trigger(u"view/sigmaEnd-1000"_s);
        QCOMPARE(missionPicture(w.record(), QLocale::c()).sigmaFull_m2, 1000.0);
        QTRY_VERIFY(symbolIn(w, "berg-3") != own);
        MainWindowHost next(w.workspace, w.interaction, w.settings);
        QCOMPARE(chosenSigmaEnd_m2(), std::optional(1000.0));
        QVERIFY(test::child<QAction>(next.window(), u"view/sigmaEnd-1000"_s).isChecked());
        w.trigger(u"view/sigmaEnd-0"_s);
        QTRY_VERIFY(symbolIn(w, "berg-3") == own);
    }

    /** A right click on the legend offers the same choices as the View menu. */
    void theLegendOffersTheChoice()
    {
        WindowFixture w(nearAndFar());
        emit w.map().contextMenuRequested(placeOnLegend(w), {}, {});
        auto& menu = test::child<QMenu>(w.window(), u"mapMenu"_s);
        const auto isChoice = [&](const QAction* action) {
            return action->menu() == &sigmaMenu(w);
        };
        QVERIFY(std::ranges::any_of(menu.actions(), isChoice));
        menu.close();
    }
};

QTEST_MAIN(TestMainWindowColours)
#include "tst_main_window_colours.moc"
