#include "tests/support/window/panel_test.h"
#include "widgets/words/plan_text.h"

#include <limits>

using namespace berg;
using namespace Qt::StringLiterals;

class TestPlanText : public QObject
{
    Q_OBJECT

private slots:
    void init() { test::failOnWarnings(); }

    void marginsAreShownAgainstTheReserve_data()
    {
        constexpr double kNever_s = -std::numeric_limits<double>::infinity();
        QTest::addColumn<double>("margin_s");
        QTest::addColumn<double>("low_s");
        QTest::addColumn<QStringList>("lines");
        const QString above = u"Home with 05:00 above the reserve"_s;
        QTest::newRow("both above")
            << 300. << 200.
            << QStringList{above, u"1 flight in 20: 03:20 or less above the reserve"_s};
        QTest::newRow("low below")
            << 300. << -1782.
            << QStringList{above, u"1 flight in 20 uses 29:42 or more of the reserve"_s};
        QTest::newRow("low never")
            << 300. << kNever_s
            << QStringList{above, u"In 1 flight in 20 the wind is too strong to return home"_s};
        QTest::newRow("both below")
            << -60. << -90.
            << QStringList{u"Home with 01:00 of the reserve used"_s,
                           u"1 flight in 20 uses 01:30 or more of the reserve"_s};
        QTest::newRow("never") << kNever_s << kNever_s
                               << QStringList{u"The wind is too strong to return home"_s};
    }
    void marginsAreShownAgainstTheReserve()
    {
        QFETCH(double, margin_s);
        QFETCH(double, low_s);
        QFETCH(QStringList, lines);
        QCOMPARE(marginLines(margin_s, low_s), lines);
    }
};

QTEST_MAIN(TestPlanText)
#include "tst_plan_text.moc"
