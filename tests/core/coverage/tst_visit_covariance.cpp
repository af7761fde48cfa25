#include "core/coverage/visit_covariance.h"
#include "tests/support/approx.h"

#include <QTest>

#include <cmath>

using namespace berg;

namespace {

constexpr double kQ_m2ps = 0.025;

ObserverSpec kalman(double sd_m, double detection = 1)
{
    return {.model = ObserverModel::Kalman, .positionSd_m = sd_m, .detection = detection};
}

/** Makes a track that was known once and then unseen for some minutes. */
Track unseenTrack(double velocitySd_mps, double velocityTime_s = 0)
{
    Track track{
        .sigma_m2 = 25, .q_m2ps = kQ_m2ps, .velocity_m2ps2 = velocitySd_mps * velocitySd_mps};
    track.velocitySpread_mps = velocitySd_mps;
    track.velocityTime_s = velocityTime_s;
    track.grow(300);
    return track;
}

/** Returns sigma of the filter after samples in the middle of each second, and its integral. */
VisitCovariance::Growth sampleBySample(Track& track, double seconds, double variance_m2)
{
    VisitCovariance::Growth result;
    constexpr int kSteps = 100; // Steps of a second.
    for (int second = 0; second < static_cast<int>(seconds); ++second)
        for (int step = 0; step < kSteps; ++step) {
            if (step == kSteps / 2)
                track.measured({}, variance_m2, track.anchor_s);
            const double before_m2 = track.sigma_m2;
            track.grow(1.0 / kSteps);
            result.cost_m2s += (before_m2 + track.sigma_m2) / 2 / kSteps;
        }
    result.sigma_m2 = track.sigma_m2;
    return result;
}

} // namespace

class TestVisitCovariance : public QObject
{
    Q_OBJECT

private slots:
    void unseenIsTheTrack_data()
    {
        QTest::addColumn<double>("velocityTime_s");
        QTest::newRow("constant velocity") << 0.0;
        QTest::newRow("velocity of ten hours") << 36'000.0;
        QTest::newRow("velocity of five minutes") << 300.0;
    }

    void unseenIsTheTrack()
    {
        QFETCH(double, velocityTime_s);
        Track track = unseenTrack(0.1, velocityTime_s);
        const VisitCovariance account(track, kalman(5), 1);
        DriftVariances known = account.start();
        const double half_m2s = account.grow(known, 20);
        const double whole_m2s = half_m2s + account.grow(known, 30);
        QVERIFY(std::abs(account.growth(account.start(), 50).cost_m2s / whole_m2s - 1) < 1e-12);
        track.grow(50);
        QVERIFY(std::abs(known.position_m2 / track.sigma_m2 - 1) < 1e-12);
        QVERIFY(std::abs(known.mixed_m2ps / track.mixed_m2ps - 1) < 1e-12);
        QVERIFY(account.deviation_m(known.position_m2) == std::sqrt(known.position_m2));
    }

    /** Sigma in view agrees with the filter, sample by sample. */
    void samplesAreTheFilter_data()
    {
        QTest::addColumn<double>("velocitySd_mps");
        QTest::addColumn<double>("seconds");
        QTest::addColumn<double>("sd_m");
        QTest::addColumn<double>("velocityTime_s");
        for (const double sd_m : {5.0, 20.0})
            for (const double velocitySd_mps : {0.0, 0.1, 0.3})
                for (const double seconds : {10.0, 18.0, 27.0})
                    for (const double velocityTime_s : {0.0, 1200.0})
                        QTest::addRow("velocity %g for %g s, %g s, %g m", velocitySd_mps,
                                      velocityTime_s, seconds, sd_m)
                            << velocitySd_mps << seconds << sd_m << velocityTime_s;
    }
    void samplesAreTheFilter()
    {
        QFETCH(double, velocitySd_mps);
        QFETCH(double, seconds);
        QFETCH(double, sd_m);
        QFETCH(double, velocityTime_s);
        Track track = unseenTrack(velocitySd_mps, velocityTime_s);
        const VisitCovariance account(track, kalman(sd_m), 1);
        DriftVariances known = account.start();
        const double predicted_m2s = account.sample(known, seconds);
        const VisitCovariance::Growth flown = sampleBySample(track, seconds, sd_m * sd_m);
        QVERIFY(std::abs(known.position_m2 / flown.sigma_m2 - 1) < 0.02);
        track.grow(200);
        QVERIFY(std::abs(account.growth(known, 200).sigma_m2 / track.sigma_m2 - 1) < 0.01);
        // Sigma is unchanged until the first sample, after half a second.
        const double waited_m2s = account.start().position_m2 / 2;
        QVERIFY(predicted_m2s < flown.cost_m2s);
        QVERIFY(predicted_m2s + waited_m2s > flown.cost_m2s * 0.9);
    }

    /** A visit in pieces, as predictions have it, has about the result of one in one piece. */
    void piecesAreTheWhole()
    {
        const VisitCovariance account(unseenTrack(0.1), kalman(5, 0.6), 1);
        DriftVariances whole = account.start();
        const double whole_m2s = account.sample(whole, 20);
        DriftVariances known = account.start();
        double sum_m2s = 0;
        for (int k = 0; k < 20; ++k)
            sum_m2s += account.sample(known, 1);
        QVERIFY(std::abs(known.position_m2 / whole.position_m2 - 1) < 0.03);
        QVERIFY(std::abs(sum_m2s / whole_m2s - 1) < 0.03);
        QCOMPARE(account.sample(known, 0), 0.0);
    }

    /** A weight multiplies the cost and changes nothing else. */
    void weightsScale()
    {
        const Track track = unseenTrack(0.1);
        const VisitCovariance one(track, kalman(5), 1);
        const VisitCovariance three(track, kalman(5), 3);
        DriftVariances known = one.start();
        DriftVariances weighted = three.start();
        const double cost_m2s = one.grow(known, 10) + one.sample(known, 15);
        const double weighted_m2s = three.grow(weighted, 10) + three.sample(weighted, 15);
        QVERIFY(std::abs(weighted_m2s / cost_m2s - 3) < 1e-9);
        QVERIFY(std::abs(weighted.velocity_m2ps2 / known.velocity_m2ps2 - 3) < 1e-9);
        QVERIFY(std::abs(three.deviation_m(weighted.position_m2) -
                         one.deviation_m(known.position_m2)) < 1e-9);
    }

    void lessIsLess()
    {
        for (const double weight : {1.0, 3.0}) {
            const VisitCovariance account(unseenTrack(0.1), kalman(5), weight);
            for (const double sigma_m2 : {-1.0, 0.0, 1e-9, 1.0, 400.0}) {
                const double deviation_m = account.deviation_m(sigma_m2);
                QVERIFY(!account.deviatesLess(sigma_m2, deviation_m));
                QVERIFY(account.deviatesLess(sigma_m2, 1.01 * deviation_m + 2e-6));
                QVERIFY(!account.deviatesLess(sigma_m2, -1));
            }
        }
    }

    void oneLookOfTheSimpleObserverTellsAll()
    {
        const VisitCovariance account({.sigma_m2 = 7, .q_m2ps = kQ_m2ps}, {}, 2);
        DriftVariances known = account.start();
        QCOMPARE(account.grow(known, 10), 10 * (14 + 10 * kQ_m2ps));
        QCOMPARE(account.sample(known, 5), 0.0);
        QCOMPARE(known.position_m2, 0.0);
    }

    void lostIcebergsAreFoundByChance()
    {
        const VisitCovariance account(unseenTrack(0.1), kalman(5), 1);
        DriftVariances never = account.start();
        account.searchLost(never, 0);
        QVERIFY(never == account.start());
        DriftVariances surely = account.start();
        account.searchLost(surely, 1);
        DriftVariances half = account.start();
        account.searchLost(half, 0.5);
        QVERIFY(surely.position_m2 < 10);
        QCOMPARE(half.position_m2, (never.position_m2 + surely.position_m2) / 2);
        QCOMPARE(half.velocity_m2ps2, (never.velocity_m2ps2 + surely.velocity_m2ps2) / 2);
    }
};

QTEST_APPLESS_MAIN(TestVisitCovariance)
#include "tst_visit_covariance.moc"
