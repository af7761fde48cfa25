#include "core/base/angles.h"
#include "core/sim/pose_tracks.h"

#include <QtTest>

using namespace berg;

namespace {

PoseFix fixAt(double time_s, double east_m, int uav = 0)
{
    return {.time_s = time_s, .uav = uav, .pose = {.position_m = {east_m, 0}}};
}

} // namespace

class TestPoseTracks : public QObject
{
    Q_OBJECT

private slots:
    void posesBetweenFixesAreInterpolated()
    {
        PoseTracks tracks(2);
        PoseFix east = fixAt(1, 100, 1);
        east.pose.psi_rad = kPi - 0.1;
        PoseFix later = fixAt(3, 200, 1);
        later.pose.psi_rad = -kPi + 0.3; // the shorter turn leads across pi
        tracks.add(east, 0);
        tracks.add(later, 0);
        QVERIFY(tracks.posesAt(0.9, 0.1).empty());
        QVERIFY(tracks.posesAt(3.1, 0.1).empty());
        const auto poses = tracks.posesAt(2, 0.1);
        QCOMPARE(poses.size(), std::size_t{2});
        QVERIFY(!poses[0]);
        QVERIFY(poses[1]->pose.position_m == Point(150, 0));
        QVERIFY(std::abs(wrapPi(poses[1]->pose.psi_rad - (kPi + 0.1))) < 1e-12);
        QVERIFY(poses[1]->hasView);
    }

    void nothingIsSeenBetweenPredictedFixes()
    {
        PoseTracks tracks(1);
        PoseFix predicted = fixAt(2, 200);
        predicted.isMeasured = false;
        for (const PoseFix& fix : {fixAt(1, 100), predicted, fixAt(3, 300), fixAt(4, 400)})
            tracks.add(fix, 0);
        QVERIFY(tracks.posesAt(1, 0.1)[0]->isJump && !tracks.posesAt(1.1, 0.1)[0]->isJump);
        QVERIFY(tracks.posesAt(1, 0.1)[0]->hasView);
        QVERIFY(!tracks.posesAt(1.5, 0.1)[0]->hasView);
        QVERIFY(!tracks.posesAt(2.5, 0.1)[0]->hasView);
        QVERIFY(tracks.posesAt(3.5, 0.1)[0]->hasView);
    }

    /** The flight was simulated up to 5 s, and a replay must not fly that part along the fixes. */
    void pathBeginsAgainAfterSimulation()
    {
        PoseTracks tracks(1);
        tracks.add(fixAt(1, 100), 0);
        tracks.add(fixAt(4, 100), 5); // too late
        tracks.add(fixAt(6, 600), 5);
        QVERIFY(tracks.posesAt(3, 0.1).empty());
        QVERIFY(tracks.posesAt(6, 0.1)[0]->pose.position_m == Point(600, 0));
        QVERIFY(tracks.posesAt(6, 0.1)[0]->isJump);
        const std::vector<PoseFix> all = tracks.until(100);
        QCOMPARE(all.size(), std::size_t{2});
        QVERIFY(all[0].isFirst && all[1].isFirst);
        PoseTracks again(1);
        again.restore(all);
        QVERIFY(again.until(100) == all);
        QVERIFY(again.until(1) == std::vector{all[0]});
    }

    /** A run file could not hold them. */
    void fixesOffThePlaneAreDropped()
    {
        PoseTracks tracks(1);
        for (const double east_m : {1.1e6, -1e308, std::nan("")})
            tracks.add(fixAt(1, east_m), 0);
        PoseFix turned = fixAt(1, 0);
        turned.pose.psi_rad = std::nan("");
        tracks.add(turned, 0);
        QVERIFY(tracks.until(100).empty());
        tracks.add(fixAt(1, -1e6), 0);
        QCOMPARE(tracks.until(100).size(), std::size_t{1});
    }

    void slowestUavIsWaitedForAWhile()
    {
        PoseTracks tracks(2);
        QVERIFY(!tracks.knownUntil_s());
        tracks.add(fixAt(1, 0, 0), 0);
        QCOMPARE(tracks.knownUntil_s().value(), 1.0);
        tracks.add(fixAt(3.5, 0, 1), 0);
        QCOMPARE(tracks.knownUntil_s().value(), 1.0);
        tracks.add(fixAt(4.5, 0, 1), 0);
        QCOMPARE(tracks.knownUntil_s().value(), 4.5); // 3.5 s of silence are too much
    }
};

QTEST_APPLESS_MAIN(TestPoseTracks)
#include "tst_pose_tracks.moc"
