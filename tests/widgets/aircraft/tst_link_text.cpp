#include "widgets/aircraft/link_text.h"

#include <QtTest>

using namespace berg;
using namespace Qt::StringLiterals;

class TestLinkText : public QObject
{
    Q_OBJECT

private slots:
    void differencesAreNamed_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("name");
        QTest::newRow("x") << u"x"_s << u"latitude"_s;
        QTest::newRow("z") << u"z"_s << u"altitude"_s;
        QTest::newRow("command") << u"command"_s << u"command"_s;
        QTest::newRow("param2") << u"param2"_s << u"parameter 2"_s;
    }

    void differencesAreNamed()
    {
        QFETCH(QString, field);
        QFETCH(QString, name);
        const SyncStatus sync{.phase = SyncPhase::Different,
                              .differences = {{.index = 1, .field = field.toStdString()}}};
        QCOMPARE(syncText(sync, AutopilotKind::Px4),
                 u"On board differs. Mission: item 2, %1"_s.arg(name));
    }

    /** Items count from 1 everywhere, and ArduPilot's home does not count. */
    void itemsCountFromOne()
    {
        QCOMPARE(itemNumber(2, AutopilotKind::ArduPilot), 2);
        QCOMPARE(itemNumber(2, AutopilotKind::Px4), 3);
        const LinkVehicle px4{.autopilot = AutopilotKind::Px4};
        const LinkVehicle plane{.autopilot = AutopilotKind::ArduPilot};
        const LinkEvent reached{.kind = LinkEvent::Kind::ItemReached, .value = 4};
        QVERIFY(linkEventText(reached, &px4).endsWith(u"item 5 reached"_s));
        QVERIFY(linkEventText(reached, &plane).endsWith(u"item 4 reached"_s));
        SyncStatus sync{.phase = SyncPhase::Failed};
        sync.transfer.failure = TransferFailure::GaveUp;
        sync.transfer.item = 4;
        QVERIFY(syncText(sync, AutopilotKind::Px4).endsWith(u"item 5"_s));
        QVERIFY(syncText(sync, AutopilotKind::ArduPilot).endsWith(u"item 4"_s));
        sync.type = MissionType::Fence;
        QVERIFY(syncText(sync, AutopilotKind::ArduPilot).endsWith(u"item 5"_s));
    }

    void steeringIsSaidOnlyWithTheFlight()
    {
        Steering steering;
        steering.begin(SteeringKind::Mission, AutopilotKind::ArduPilot, 10);
        QVERIFY(steeringText(steering, true) != steeringText(steering, false));
        steering.begin(SteeringKind::Guided, AutopilotKind::ArduPilot, 15);
        QVERIFY(steeringText(steering, true) != steeringText(steering, false));
    }
};

QTEST_APPLESS_MAIN(TestLinkText)
#include "tst_link_text.moc"
