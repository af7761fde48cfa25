#include "tests/support/window/panel_test.h"
#include "widgets/panels/flight/alarm_strip.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

using namespace berg;
using namespace Qt::StringLiterals;
using test::child;

class TestAlarmStrip : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    /** Aircraft without a UAV are about nothing on the map, and yet each is acknowledged alone. */
    void subjectsAreAcknowledgedOneByOne()
    {
        AlarmStrip strip;
        QSignalSpy raised(&strip, &AlarmStrip::raised);
        const FlightNotice third{
            .kind = NoticeKind::ContactLost, .text = u"Aircraft 3"_s, .subject = "3.1"};
        const FlightNotice fourth{
            .kind = NoticeKind::ContactLost, .text = u"Aircraft 4"_s, .subject = "4.1"};
        strip.showNotices({third});
        child<QPushButton>(strip, u"acknowledge1"_s).click();
        QVERIFY(child<QToolButton>(strip, u"flightNotice1"_s).parentWidget()->isHidden());
        strip.showNotices({third, fourth});
        QCOMPARE(raised.count(), 2);
        QVERIFY(!child<QToolButton>(strip, u"flightNotice1"_s).parentWidget()->isHidden());
        QCOMPARE(child<QToolButton>(strip, u"flightNotice1"_s).text(), u"Aircraft 4"_s);
        const FlightNotice taken{
            .kind = NoticeKind::PilotTookOver, .text = u"Pilot"_s, .subject = "3.1"};
        strip.showNotices({third, taken});
        QCOMPARE(child<QToolButton>(strip, u"flightNotice1"_s).text(), u"Pilot"_s);
    }
};

QTEST_MAIN(TestAlarmStrip)
#include "tst_alarm_strip.moc"
