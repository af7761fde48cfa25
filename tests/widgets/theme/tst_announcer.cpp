#include "tests/support/panel_test.h"
#include "widgets/theme/announcer.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

class TestAnnouncer : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void theFirstIsToldAtOnce()
    {
        Announcer announcer;
        QSignalSpy told(&announcer, &Announcer::told);
        announcer.say(u"Flying"_s);
        QCOMPARE(told.count(), 1);
        QCOMPARE(announcer.accessibleName(), u"Flying"_s);
    }

    void theSameIsToldAgain()
    {
        Announcer announcer;
        QSignalSpy told(&announcer, &Announcer::told);
        announcer.say(u"Paused"_s);
        announcer.say(u"Paused"_s);
        QTRY_COMPARE(told.count(), 2);
        QCOMPARE(announcer.accessibleName(), u"Paused"_s);
    }

    /** Of a fast flight more comes than can be heard: the newest. */
    void whatComesSoonAfterIsToldTogether()
    {
        Announcer announcer;
        QSignalSpy told(&announcer, &Announcer::told);
        announcer.say(u"0"_s);
        for (int i = 1; i <= 9; ++i)
            announcer.say(QString::number(i));
        QTRY_COMPARE(told.count(), 2);
        QCOMPARE(told[0][0].toString(), u"0"_s);
        QCOMPARE(told[1][0].toString(), u"6. 7. 8. 9"_s);
    }
};

QTEST_MAIN(TestAnnouncer)
#include "tst_announcer.moc"
