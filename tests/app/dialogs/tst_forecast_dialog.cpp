#include "app/dialogs/forecast_dialog.h"
#include "core/scenario/utc_time.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** A scenario whose run is within the forecast of tests/data/forecast. */
Scenario scenarioOfForecast()
{
    Scenario scenario;
    scenario.origin = {64.5, -59.8};
    scenario.startUtc = "2026-05-01T12:00:00Z";
    scenario.duration_s = 3600;
    return scenario;
}

QString dataFile(const QString& name)
{
    return QStringLiteral(BERG_TEST_DATA "/forecast/") + name;
}

/** A dialog about a scenario, and its parts. */
struct ForecastDialogFixture
{
    explicit ForecastDialogFixture(const Scenario& scenario)
        : dialog({.scenario = std::make_shared<const Scenario>(scenario),
                  .openPath = [this](QWidget*) { return path; }})
    {
    }

    template <class Widget>
    Widget& part(const QString& name)
    {
        return *dialog.findChild<Widget*>(name);
    }
    void open(const QString& file)
    {
        path = dataFile(file);
        part<QPushButton>(u"openForecastButton"_s).click();
    }

    QString path;
    ForecastDialog dialog;
};

} // namespace

class TestForecastDialog : public QObject
{
    Q_OBJECT

private slots:
    void aFileIsReadAndShown()
    {
        ForecastDialogFixture f(scenarioOfForecast());
        auto& set = f.part<QPushButton>(u"setForecastButton"_s);
        QVERIFY(!set.isEnabled());
        QVERIFY(!f.dialog.choice().forecast);
        f.open(u"locationforecast.json"_s);
        QTRY_VERIFY(set.isEnabled());
        const auto forecast = f.dialog.choice().forecast;
        QVERIFY(forecast);
        QCOMPARE(forecast->places.size(), 1U);
        QCOMPARE(forecast->places[0].series.size(), 5U); // 12 o'clock to noon of the next day
        const auto& table = f.part<QTableWidget>(u"forecastTable"_s);
        QCOMPARE(table.rowCount(), 5);
        QVERIFY(table.item(0, 1)->text().startsWith(u"8.0"_s));
        QVERIFY(table.isColumnHidden(7)); // no current
        QVERIFY(f.part<QLabel>(u"forecastSummary"_s)
                    .text()
                    .startsWith(u"Source: MET Norway locationforecast\nIssued "_s));
    }

    void aSecondFileIsCombined()
    {
        ForecastDialogFixture first(scenarioOfForecast());
        first.open(u"locationforecast.json"_s);
        QTRY_VERIFY(first.dialog.choice().forecast);
        Scenario scenario = scenarioOfForecast();
        scenario.forecast = first.dialog.choice().forecast;
        ForecastDialogFixture second(scenario);
        second.open(u"oceanforecast.json"_s);
        auto& set = second.part<QPushButton>(u"setForecastButton"_s);
        QTRY_VERIFY(set.isEnabled());
        QVERIFY(gives(second.dialog.choice().forecast->places[0], ForecastQuantity::Wind));
        QVERIFY(gives(second.dialog.choice().forecast->places[0], ForecastQuantity::Current));
        second.part<QCheckBox>(u"combineForecasts"_s).setChecked(false);
        QVERIFY(!gives(second.dialog.choice().forecast->places[0], ForecastQuantity::Wind));
        second.part<QPushButton>(u"removeForecastButton"_s).click();
        QVERIFY(!second.dialog.choice().forecast);
        QVERIFY(set.isEnabled());
    }

    void faultsAreShown()
    {
        ForecastDialogFixture f(scenarioOfForecast());
        f.path = dataFile(u"missing.nc"_s);
        f.dialog.read(f.path);
        const auto& note = f.part<QLabel>(u"forecastNote"_s);
        QTRY_VERIFY(note.text().contains(u"missing.nc"_s));
        QVERIFY(!f.part<QPushButton>(u"setForecastButton"_s).isEnabled());
        Scenario timeless = scenarioOfForecast();
        timeless.startUtc.clear();
        ForecastDialogFixture none(timeless);
        none.open(u"locationforecast.json"_s);
        QTRY_VERIFY(!none.part<QLabel>(u"forecastNote"_s).text().isEmpty());
    }
};

QTEST_MAIN(TestForecastDialog)
#include "tst_forecast_dialog.moc"
