#include "tests/support/window/panel_test.h"
#include "tests/support/window/patience.h"
#include "widgets/theme/announcer.h"

#include <QSignalSpy>

using namespace berg;
using namespace Qt::StringLiterals;

class TestAnnouncer : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void firstSentenceIsAnnouncedAtOnce()
    {
        Announcer announcer;
        QSignalSpy announced(&announcer, &Announcer::announced);
        announcer.say(u"Flying"_s);
        QCOMPARE(announced.count(), 1);
        QCOMPARE(announcer.accessibleName(), u"Flying"_s);
    }

    void equalSentenceIsAnnouncedAgain()
    {
        Announcer announcer;
        QSignalSpy announced(&announcer, &Announcer::announced);
        announcer.say(u"Paused"_s);
        announcer.say(u"Paused"_s);
        QTRY_COMPARE(announced.count(), 2);
        QCOMPARE(announcer.accessibleName(), u"Paused"_s);
    }

    /** A fast flight has more events than can be heard: the newest are announced. */
    void sentencesWithinASecondAreJoined()
    {
        Announcer announcer;
        QSignalSpy announced(&announcer, &Announcer::announced);
        announcer.say(u"0"_s);
        for (int i = 1; i <= 9; ++i)
            announcer.say(QString::number(i));
        QTRY_COMPARE(announced.count(), 2);
        QCOMPARE(announced[0][0].toString(), u"0"_s);
        QCOMPARE(announced[1][0].toString(), u"6. 7. 8. 9"_s);
    }
};

QTEST_MAIN(TestAnnouncer)
#include "tst_announcer.moc"
