#include "tests/support/flight/fleet_watch.h"

#include <QTest>

using namespace berg::test;

/** Random combinations of many features. */
class TestRandomFleets : public QObject
{
    Q_OBJECT

private slots:
    /** `bench_loop` runs 2000 of them. */
    void randomFleetsFlyWithoutFaults()
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

    /** Changing velocities once looked like sightings at each step. */
    void randomFleetsWithChangingVelocitiesFlyWithoutFaults()
    {
        for (std::uint64_t seed = 1; seed <= 25; ++seed) {
            const FleetFaults faults = faultsOf(seed, true);
            QVERIFY2(!faults.any(), qPrintable(QString::number(seed) + ": " +
                                               QString::fromStdString(faults.first)));
        }
    }

    /** A fixed route assigned the iceberg to a UAV flying home: plans were made every second. */
    void assignedIcebergsAreFlownTo()
    {
        const FleetFaults faults = faultsOf(777014);
        QVERIFY2(!faults.any(), qPrintable(QString::fromStdString(faults.first)));
    }
};

QTEST_APPLESS_MAIN(TestRandomFleets)
#include "tst_random_fleets.moc"
