#include "core/base/number_text.h"
#include "tests/support/window/map_fixture.h"
#include "tests/support/window/window_fixture.h"
#include "widgets/panels/flight/flight_card.h"
#include "widgets/theme/language.h"
#include "widgets/theme/quantity_text.h"

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>

#include <cmath>

using namespace berg;
using namespace Qt::StringLiterals;
using test::WindowFixture;

namespace {

bool flyToEnd(WindowFixture& w)
{
    w.workspace.fly(kFastestRate);
    return w.until(RunPhase::Finished);
}

QWidget& card(WindowFixture& w)
{
    return test::child<QWidget>(w.window(), u"flightCard"_s);
}

QString text(WindowFixture& w, const QString& name)
{
    return test::child<QLabel>(w.window(), name).text();
}

void press(WindowFixture& w, const QString& name)
{
    test::child<QAbstractButton>(w.window(), name).click();
}

/** Returns the rectangle of the widget in the window. */
QRect placeOf(WindowFixture& w, const QWidget& widget)
{
    return {widget.mapTo(&w.window(), QPoint()), widget.size()};
}

} // namespace

/** The card at the end of a run. */
class TestMainWindowEnd : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { installLanguage(u"en"_s); }
    void init() { test::failOnWarnings(); }

    void nothingIsLeftOfThePlan()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(flyToEnd(w));
        QTRY_COMPARE(test::child<QTableView>(w.window(), u"planTable"_s).model()->rowCount(), 0);
        QCOMPARE(text(w, u"planEmpty"_s), u"The run is complete."_s);
        QVERIFY(!text(w, u"planSummary"_s).contains(u"0 m,"_s));
        QVERIFY(text(w, u"planSummary"_s).startsWith(u"ζ at the end: "_s));
        QCOMPARE(text(w, u"planDistance"_s), u"–"_s);
        QCOMPARE(text(w, u"planState"_s), u"Run complete"_s);
        QVERIFY(!text(w, u"hintLabel"_s).contains(u"while flying"_s));
        const auto& lock = test::child<QToolButton>(w.window(), u"lockButton"_s);
        QCOMPARE(lock.accessibleName(), u"Scenario locked"_s);
        w.workspace.seek(100);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        QTRY_VERIFY(test::child<QTableView>(w.window(), u"planTable"_s).model()->rowCount() > 0);
    }

    void cardShowsTheResultOfTheRun()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(w.until([&] { return w.workspace.forecasts().isComplete(); }));
        QVERIFY(!card(w).isVisible());
        QVERIFY(flyToEnd(w));
        QTRY_VERIFY(card(w).isVisible());
        QVERIFY(w.map().rect().contains(card(w).geometry()));
        const Metrics& metrics = w.record().now.metrics;
        QCOMPARE(text(w, u"flightCardZeta"_s),
                 u"ζ %1 m² s"_s.arg(significantText(metrics.zeta_m2s, 4, QLocale())));
        QCOMPARE(text(w, u"flightCardVisits"_s), QString::number(metrics.visits));
        QVERIFY(text(w, u"flightCardPredicted"_s).contains(u"%"_s));
        QVERIFY(text(w, u"flightCardUnseen"_s).contains(u"berg-"_s));
        const ZetaPrediction predicted = predictZeta(w.scenario()).value();
        QVERIFY(w.workspace.predicted() == predicted);
        const QString mean = significantText(predicted.mean_m2s, 4, QLocale());
        QVERIFY(text(w, u"flightCardPredicted"_s).endsWith(u"(%1 m² s)"_s.arg(mean)));
        QVERIFY(text(w, u"policyForecast"_s)
                    .startsWith(u"Predicted before take-off: ζ %1 m² s"_s.arg(mean)));
        QVERIFY(
            text(w, u"flightCardRange"_s)
                .endsWith(u" %1 to %2"_s.arg(significantText(predicted.least_m2s, 4, QLocale()),
                                             significantText(predicted.most_m2s, 4, QLocale()))));
    }

    /** The log has the number of the card. */
    void logAgreesWithTheCard()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(w.until([&] { return w.workspace.forecasts().isComplete(); }));
        QVERIFY(flyToEnd(w));
        std::string page;
        connect(&w.workspace.runner(), &MissionRunner::exportReady, &w.window(),
                [&](const std::vector<ExportFile>& files) { page = files.front().content; });
        const QTemporaryDir folder;
        w.workspace.runner().requestExport(
            {.formatId = "log-html", .path = folder.filePath(u"log.html"_s)});
        QVERIFY(w.until([&] { return !page.empty(); }));
        const double mean_m2s = w.workspace.predicted().value().mean_m2s;
        const std::string expected = printedNumber(std::round(mean_m2s), 0) + " m²\u00a0s";
        const std::size_t fact = page.find("Predicted before take-off");
        QVERIFY(fact != std::string::npos);
        QVERIFY2(page.find(expected, fact) < fact + 100, expected.c_str());
    }

    void cardShowsThePlaceInThePrediction_data()
    {
        QTest::addColumn<double>("zeta_m2s");
        QTest::addColumn<QString>("expected");
        QTest::newRow("below") << 90. << u"below 100.0 to 200.0"_s;
        QTest::newRow("inside") << 150. << u"inside 100.0 to 200.0"_s;
        QTest::newRow("above") << 201. << u"above 100.0 to 200.0"_s;
    }

    void cardShowsThePlaceInThePrediction()
    {
        QFETCH(double, zeta_m2s);
        QFETCH(QString, expected);
        QWidget map;
        FlightCard card(&map);
        card.showSummary({.zeta_m2s = zeta_m2s});
        const auto& range = test::child<QLabel>(card, u"flightCardRange"_s);
        QCOMPARE(range.text(), u"–"_s);
        card.showSummary(
            {.zeta_m2s = zeta_m2s,
             .predicted = ZetaPrediction{.mean_m2s = 140, .least_m2s = 100, .most_m2s = 200}});
        QCOMPARE(range.text(), expected);
    }

    void cardSaysWhyNothingWasPredicted()
    {
        QWidget map;
        FlightCard card(&map);
        const auto& predicted = test::child<QLabel>(card, u"flightCardPredicted"_s);
        card.showSummary({.zeta_m2s = 100});
        QCOMPARE(predicted.text(), u"–"_s);
        card.showSummary({.zeta_m2s = 100, .wasChanged = true});
        QCOMPARE(predicted.text(), u"changed in flight"_s);
    }

    void cardGoesWhenItIsClosedOrAnotherRunBegins()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(flyToEnd(w));
        QTRY_VERIFY(card(w).isVisible());
        w.workspace.seek(100); // looked back at
        QTRY_VERIFY(!card(w).isVisible());
        w.workspace.seekLatest();
        QTRY_VERIFY(card(w).isVisible());
        press(w, u"flightCardClose"_s);
        QVERIFY(!card(w).isVisible());
        w.workspace.seek(100);
        QVERIFY(w.until([&] { return w.record().instant.has_value(); }));
        w.workspace.seekLatest();
        QVERIFY(w.until([&] { return !w.record().instant; }));
        QVERIFY(!card(w).isVisible());
        w.workspace.reset();
        QVERIFY(w.untilReady());
        QVERIFY(flyToEnd(w));
        QTRY_VERIFY(card(w).isVisible());
        w.workspace.reset();
        QTRY_VERIFY(!card(w).isVisible());
    }

    void closedCardStaysClosedInOtherUnits()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(flyToEnd(w));
        QTRY_VERIFY(card(w).isVisible());
        press(w, u"flightCardClose"_s);
        w.trigger(u"units/distance-nautical"_s);
        QTest::qWait(0); // another window
        QVERIFY(!card(w).isVisible());
        w.trigger(u"units/distance-metric"_s);
        QTest::qWait(0);
    }

    void nothingIsSaidToBeRemovedWhenItIsNot()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(flyToEnd(w));
        w.workspace.selection().set({"berg-2"});
        QSignalSpy refused(&w.workspace, &Workspace::refused);
        QCOMPARE(w.workspace.remove({"berg-2"}), 0);
        QCOMPARE(refused.count(), 1);
        w.map().setFocus();
        QTest::keyClick(&w.map(), Qt::Key_Delete);
        QCOMPARE(refused.count(), 2);
        QVERIFY(flownRun(w)->interventions.empty());
    }

    void cardLeadsOn()
    {
        WindowFixture w(test::MapFixture::shortRun());
        QVERIFY(flyToEnd(w));
        QTRY_VERIFY(card(w).isVisible());
        press(w, u"flightCardCompare"_s);
        const auto& comparison = test::child<QDockWidget>(w.window(), u"comparisonDock"_s);
        QTRY_VERIFY(!comparison.visibleRegion().isEmpty());
        press(w, u"flightCardSave"_s);
        QCOMPARE(w.interaction.suggested, QStringList{u"flight.bergrun"_s});
        press(w, u"flightCardReport"_s);
        QCOMPARE(w.interaction.offers.size(), 1U);
        QCOMPARE(w.interaction.offers.front().suggested.formatId, std::string("log"));
        QVERIFY(card(w).isVisible());
    }

    /** Nothing round it comes or goes at take-off or at the end. */
    void mapAndTimeLineStandStill()
    {
        WindowFixture w(test::MapFixture::shortRun());
        const auto& timeLine = test::child<QWidget>(w.window(), u"timeLine"_s);
        const QRect map = placeOf(w, w.map());
        const QRect line = placeOf(w, timeLine);
        const auto areWhereTheyWere = [&] {
            return placeOf(w, w.map()) == map && placeOf(w, timeLine) == line;
        };
        w.workspace.stepTicks(100);
        QVERIFY(w.until(RunPhase::Paused));
        QTRY_VERIFY(areWhereTheyWere());
        QVERIFY(flyToEnd(w));
        QTRY_VERIFY(card(w).isVisible());
        QTRY_VERIFY(areWhereTheyWere());
        w.workspace.reset();
        QVERIFY(w.untilReady());
        QTRY_VERIFY(areWhereTheyWere());
    }
};

QTEST_MAIN(TestMainWindowEnd)
#include "tst_main_window_end.moc"
