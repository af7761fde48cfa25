#include "tests/support/approx.h"
#include "tests/support/flight/scenario_builder.h"
#include "tests/support/window/panel_test.h"
#include "widgets/flight/sigma_end.h"

#include <QTemporaryDir>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

/** Two icebergs 5 km apart, the UAV at one of them: a round tour of 10 km takes 455 s. */
Scenario twoIcebergs(double duration_s)
{
    Scenario scenario = test::emptySea(duration_s);
    test::addIceberg(scenario, 0, 0);
    test::addIceberg(scenario, 3000, 4000);
    return scenario;
}

} // namespace

class TestSigmaEnd : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }
    void cleanup() { chooseSigmaEnd(std::nullopt); }

    void theEndIsWhatIcebergsReachUnseen()
    {
        // 5 m^2 and 0.025 m^2/s for a tour (455 s): 16.4 m^2.
        COMPARE_NEAR(sigmaEnd_m2(twoIcebergs(4000)), 20, 1e-9);
        // For the 100 s of a short run: 7.5 m^2.
        COMPARE_NEAR(sigmaEnd_m2(twoIcebergs(100)), 8, 1e-9);
        // Two UAVs need half the time: 10.7 m^2.
        Scenario shared = twoIcebergs(4000);
        shared.uavs.push_back(shared.uavs.front());
        COMPARE_NEAR(sigmaEnd_m2(shared), 15, 1e-9);
        QVERIFY(sigmaEnd_m2(test::emptySea()) > 0);
    }

    void anIcebergAsGoodAsLostDoesNotCount()
    {
        Scenario scenario = twoIcebergs(100);
        test::addIceberg(scenario, 1000, 0);
        test::addIceberg(scenario, 2000, 0);
        scenario.icebergs[3].sigma0_m2 = 900;
        COMPARE_NEAR(sigmaEnd_m2(scenario), 8, 1e-9);
        scenario.icebergs[2].sigma0_m2 = 900; // half of them are not exceptions
        COMPARE_NEAR(sigmaEnd_m2(scenario), 1000, 1e-9);
        scenario.icebergs[3].sigma0_m2 = 20; // nor is four times as much as the others
        scenario.icebergs[2].sigma0_m2 = 5;
        COMPARE_NEAR(sigmaEnd_m2(scenario), 30, 1e-9);
    }

    void theChoiceOfTheUserHoldsForAll()
    {
        chooseSigmaEnd(200);
        COMPARE_NEAR(sigmaEnd_m2(twoIcebergs(100)), 200, 1e-9);
        COMPARE_NEAR(ownSigmaEnd_m2(twoIcebergs(100)), 8, 1e-9);
        chooseSigmaEnd(std::nullopt);
        COMPARE_NEAR(sigmaEnd_m2(twoIcebergs(100)), 8, 1e-9);
    }

    void settingsThatAreNoEndAreNone()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"settings.ini"_s), QSettings::IniFormat);
        QVERIFY(!readSigmaEnd_m2(settings));
        for (const QString& text : {u"-5"_s, u"nan"_s, u"inf"_s, u"dark"_s}) {
            settings.setValue(kSigmaEndKey, text);
            QVERIFY(!readSigmaEnd_m2(settings));
        }
        settings.setValue(kSigmaEndKey, u"50"_s);
        QCOMPARE(readSigmaEnd_m2(settings), std::optional(50.0));
    }
};

QTEST_MAIN(TestSigmaEnd)
#include "tst_sigma_end.moc"
