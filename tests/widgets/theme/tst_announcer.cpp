#include "tests/support/panel_test.h"
#include "widgets/theme/announcer.h"

#include <QAccessible>

using namespace berg;
using namespace Qt::StringLiterals;

namespace {

QStringList told; ///< what a screen reader would have spoken

void hear(QAccessibleEvent* event)
{
    if (event->type() == QAccessible::ObjectShow)
        if (const auto* announcer = qobject_cast<Announcer*>(event->object()))
            told << announcer->accessibleName();
}

} // namespace

class TestAnnouncer : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QAccessible::setActive(true);
        QAccessible::installUpdateHandler(&hear);
    }
    void init()
    {
        test::failOnWarnings();
        told.clear();
    }
    void cleanupTestCase() { QAccessible::installUpdateHandler(nullptr); }

    void theFirstIsToldAtOnce()
    {
        Announcer announcer;
        announcer.say(u"Flying"_s);
        QCOMPARE(told, QStringList{u"Flying"_s});
    }

    void theSameIsToldAgain()
    {
        Announcer announcer;
        announcer.say(u"Paused"_s);
        announcer.say(u"Paused"_s);
        QTRY_COMPARE(told, QStringList(2, u"Paused"_s));
    }

    /** Of a fast flight more comes than can be heard: the newest. */
    void whatComesSoonAfterIsToldTogether()
    {
        Announcer announcer;
        announcer.say(u"0"_s);
        for (int i = 1; i <= 9; ++i)
            announcer.say(QString::number(i));
        QTRY_COMPARE(told.size(), 2);
        QCOMPARE(told, (QStringList{u"0"_s, u"6. 7. 8. 9"_s}));
    }
};

QTEST_MAIN(TestAnnouncer)
#include "tst_announcer.moc"
