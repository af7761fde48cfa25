#include "tests/support/fleet_watch.h"

#include <QTest>

using namespace berg::test;

/** Many things at once: what nobody would have thought of to put together. */
class TestRandomFleets : public QObject
{
    Q_OBJECT

private slots:
    /** By hand, 2000 of them: `bench_loop`. */
    void haveNoFaults()
    {
        int losses = 0;
        int sorties = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const FleetFaults faults = faultsOf(seed);
            QVERIFY2(!faults.any(), qPrintable(QString::number(seed) + ": " +
                                               QString::fromStdString(faults.first)));
            losses += faults.losses;
            sorties += faults.sorties;
        }
        QVERIFY(losses > 10);
        QVERIFY(sorties > 20);
    }

    /** The same with velocities that change, which once looked like sightings at each step. */
    void changingVelocitiesMakeNoFaults()
    {
        for (std::uint64_t seed = 1; seed <= 25; ++seed) {
            const FleetFaults faults = faultsOf(seed, true);
            QVERIFY2(!faults.any(), qPrintable(QString::number(seed) + ": " +
                                               QString::fromStdString(faults.first)));
        }
    }

    /** Its kept route had the iceberg with a UAV that was on its way home: plans every second. */
    void assignedIcebergsAreFlownTo()
    {
        const FleetFaults faults = faultsOf(777014);
        QVERIFY2(!faults.any(), qPrintable(QString::fromStdString(faults.first)));
    }
};

QTEST_APPLESS_MAIN(TestRandomFleets)
#include "tst_random_fleets.moc"
